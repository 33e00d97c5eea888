#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "errors.h"

namespace anisoquad {

/// Progress and cancel for everything that takes longer than a second. One object is handed down the whole way of the data.
class Context {
  public:
    /// @param stage name of the running stage; @param fraction done of the whole run, 0…1. Return false to cancel.
    using Callback = std::function<bool(std::string_view stage, double fraction)>;

    Context() = default;
    explicit Context(Callback callback) : callback_(std::move(callback)) {}

    /// Starts a stage that covers [from, to] of the whole run.
    void begin_stage(std::string_view stage, double from, double to) {
        stage_ = stage;
        from_ = from;
        to_ = to;
        report(0.0);
    }

    /// @param fraction of the running stage. @throws Error{cancelled}
    void report(double fraction) const {
        fraction_ = fraction;
        breathe();
    }

    /// Asks whether to go on where no share of the work is done yet that is worth a report. @throws Error{cancelled}
    void breathe() const {
        if (callback_ && !callback_(stage_, from_ + (to_ - from_) * fraction_)) {
            throw Error(ErrorCode::cancelled, "Meshing was cancelled.");
        }
    }

    /// The same in a loop, every kStride steps. @param i counts the steps
    void breathe_at(std::int64_t i) const {
        if (i % kStride == 0) breathe();
    }

  private:
    static constexpr std::int64_t kStride = 1 << 16;
    Callback callback_;
    std::string_view stage_ = "";
    double from_ = 0.0;
    double to_ = 1.0;
    mutable double fraction_ = 0.0;
};

/// A context that reports to nobody and never cancels.
inline Context& no_context() {
    static thread_local Context context;
    return context;
}

}  // namespace anisoquad
