#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace anisoquad::generated {

/// Decisions read from bytes, so that a fuzzer's mutations of the bytes are small changes of what is made. Zero after the end.
class ByteSource {
  public:
    explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    int byte() { return next_ < bytes_.size() ? bytes_[next_++] : 0; }
    /// 0 … n − 1. @pre 0 < n ≤ 65536
    int below(int n) {
        const int value = n > 256 ? 256 * byte() + byte() : byte();
        return value % n;
    }
    /// low … high, both included.
    int between(int low, int high) { return low + below(high - low + 1); }
    /// True once in n times.
    bool one_in(int n) { return byte() % n == n - 1; }
    /// 0 … 1, in steps of 1/255.
    double fraction() { return byte() / 255.0; }
    /// −1 … 1.
    double signed_fraction() { return 2.0 * fraction() - 1.0; }
    bool at_end() const { return next_ >= bytes_.size(); }

  private:
    std::span<const std::uint8_t> bytes_;
    std::size_t next_ = 0;
};

}  // namespace anisoquad::generated
