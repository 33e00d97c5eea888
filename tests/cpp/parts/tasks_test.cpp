#include "parts/tasks.h"

#include <gtest/gtest.h>
#include <tbb/info.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "parallel.h"

namespace anisoquad {
namespace {

using namespace std::chrono_literals;

TEST(Tasks, AllRunOnceAndTheHeaviestFirst) {
    for (const int threads : {1, 2, 3}) {
        const std::vector<std::int32_t> weights{3, 10, 1, 7};
        std::vector<int> calls(weights.size(), 0);
        std::vector<std::int32_t> order;
        with_threads(threads, [&] {
            run_tasks(weights, no_context(), [&](std::int32_t i, Context&) {
                ++calls[static_cast<std::size_t>(i)];
                if (threads == 1) order.push_back(i);
            });
        });
        EXPECT_EQ(calls, (std::vector<int>{1, 1, 1, 1}));
        if (threads == 1) {
            EXPECT_EQ(order, (std::vector<std::int32_t>{1, 3, 0, 2}));
        }
    }
    run_tasks({}, no_context(), [](std::int32_t, Context&) { FAIL(); });
}

TEST(Tasks, ProgressGoesByWeightAndIsToldByTheCallerOnly) {
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<double> told;
    Context context([&](std::string_view, double fraction) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        told.push_back(fraction);
        return true;
    });
    context.begin_stage("", 0.0, 1.0);
    with_threads(1, [&] {
        run_tasks(std::vector<std::int32_t>{1, 3}, context, [&](std::int32_t, Context& own) { own.report(0.5); });
    });
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_TRUE(std::find(told.begin(), told.end(), 3.0 / 8.0) != told.end());
    EXPECT_TRUE(std::find(told.begin(), told.end(), 7.0 / 8.0) != told.end());
    told.clear();
    with_threads(2, [&] {
        run_tasks(std::vector<std::int32_t>{1, 1, 1}, context, [&](std::int32_t, Context& own) {
            std::this_thread::sleep_for(5ms);
            own.report(0.5);
        });
    });
    EXPECT_FALSE(told.empty());
}

TEST(Tasks, ACancelEndsThemAll) {
    // Where there is one core, TBB has no second thread that could begin a task.
    for (const int threads : {1, std::min(2, tbb::info::default_concurrency())}) {
        std::atomic<int> ended = 0;
        std::atomic<int> begun = 0;
        Context context([&](std::string_view, double) { return begun < 2; });
        const auto endless = [&](std::int32_t, Context& own) {
            ++begun;
            try {
                for (;;) own.breathe();
            } catch (const Error&) {
                ++ended;
                throw;
            }
        };
        with_threads(threads, [&] {
            if (threads == 1) begun = 1;
            try {
                run_tasks(std::vector<std::int32_t>{1, 1, 1}, context, endless);
                ADD_FAILURE();
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ErrorCode::cancelled);
            }
        });
        EXPECT_EQ(ended, begun - (threads == 1 ? 1 : 0));
    }
}

TEST(Tasks, TheFirstFailureReachesTheCaller) {
    const auto fail = [](std::int32_t i, Context&) {
        if (i > 0) throw std::runtime_error(std::to_string(i));
    };
    with_threads(2, [&] {
        try {
            run_tasks(std::vector<std::int32_t>{1, 1, 5}, no_context(), fail);
            ADD_FAILURE();
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "1");
        }
    });
}

}  // namespace
}  // namespace anisoquad
