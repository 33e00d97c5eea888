#pragma once

#include <compare>
#include <cstdint>

namespace anisoquad {

/// An index into one of the mesh's arrays, typed so that a vertex is never taken for a face. Passed by value.
template <class Tag>
class Handle {
  public:
    constexpr Handle() = default;
    constexpr explicit Handle(std::int32_t index) : index_(index) {}

    constexpr std::int32_t index() const { return index_; }
    constexpr bool is_valid() const { return index_ >= 0; }
    constexpr auto operator<=>(const Handle&) const = default;

  private:
    std::int32_t index_ = -1;
};

using Vertex = Handle<struct VertexTag>;
using HalfEdge = Handle<struct HalfEdgeTag>;
using Edge = Handle<struct EdgeTag>;
using Face = Handle<struct FaceTag>;

}  // namespace anisoquad
