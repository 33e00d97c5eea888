#include "parts/tasks.h"

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>
#include <vector>

namespace anisoquad {
namespace {

using namespace std::chrono_literals;
constexpr auto kPatience = 20ms;  ///< of the calling thread, between two questions whether to go on

class Tasks {
  public:
    Tasks(std::span<const std::int32_t> weights, const Context& context, const std::function<void(std::int32_t, Context&)>& task)
        : weights_(weights), context_(context), task_(task), order_(weights.size()), failures_(weights.size()) {
        std::iota(order_.begin(), order_.end(), 0);
        std::stable_sort(order_.begin(), order_.end(), [&](std::int32_t a, std::int32_t b) { return weight(a) > weight(b); });
        total_ = std::max(1.0, std::accumulate(weights.begin(), weights.end(), 0.0));
    }

    void run() {
        const int helpers = std::min(tbb::this_task_arena::max_concurrency(), static_cast<int>(order_.size())) - 1;
        tbb::task_group group;
        for (int i = 0; i < helpers; ++i) group.run([&] { work(); });
        work();
        wait();
        group.wait();  // helpers that never began find no task
        if (not_to_go_on_) std::rethrow_exception(not_to_go_on_);
        for (const std::exception_ptr& failure : failures_) {
            if (failure) std::rethrow_exception(failure);
        }
    }

  private:
    double weight(std::int32_t task) const { return weights_[static_cast<std::size_t>(task)]; }

    /// Takes task after task until there is none.
    void work() {
        for (;;) {
            const std::size_t i = next_++;
            if (i >= order_.size()) return;
            perform(order_[i]);
            const std::lock_guard lock(mutex_);
            ++finished_;
            changed_.notify_all();
        }
    }

    void perform(std::int32_t task) {
        double last = 0.0;
        Context context([&](std::string_view, double fraction) {
            done_.fetch_add(weight(task) * (fraction - last));
            last = fraction;
            if (std::this_thread::get_id() == caller_) ask();
            return !cancelled_;
        });
        try {
            context.breathe();
            task_(task, context);
            done_.fetch_add(weight(task) * (1.0 - last));
        } catch (...) {
            failures_[static_cast<std::size_t>(task)] = std::current_exception();
        }
    }

    void wait() {
        std::unique_lock lock(mutex_);
        while (!changed_.wait_for(lock, kPatience, [&] { return finished_ == order_.size(); })) {
            lock.unlock();
            ask();
            lock.lock();
        }
    }

    /// Whether to go on: of the calling thread only.
    void ask() {
        if (cancelled_) return;
        try {
            context_.report(std::min(1.0, done_ / total_));
        } catch (...) {
            not_to_go_on_ = std::current_exception();
            cancelled_ = true;
        }
    }

    std::span<const std::int32_t> weights_;
    const Context& context_;
    const std::function<void(std::int32_t, Context&)>& task_;
    const std::thread::id caller_ = std::this_thread::get_id();
    std::vector<std::int32_t> order_;  ///< in which the tasks are begun
    double total_ = 1.0;               ///< weight
    std::atomic<std::size_t> next_ = 0;
    std::atomic<double> done_ = 0.0;  ///< weight
    std::atomic<bool> cancelled_ = false;
    std::exception_ptr not_to_go_on_;
    std::vector<std::exception_ptr> failures_;  ///< per task
    std::mutex mutex_;
    std::condition_variable changed_;
    std::size_t finished_ = 0;  ///< guarded by mutex_
};

}  // namespace

void run_tasks(std::span<const std::int32_t> weights, const Context& context,
               const std::function<void(std::int32_t, Context&)>& task) {
    Tasks(weights, context, task).run();
}

}  // namespace anisoquad
