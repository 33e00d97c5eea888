#pragma once

#include "generated/byte_source.h"
#include "shapes.h"

/// Surfaces made of decisions: what a mesher has to cope with, up to about 400 triangles.
namespace anisoquad::generated {

/// A surface of one of many kinds (grids with holes, bands, cones, spheres, tori, boxes, unions of cubes of any genus, fans of
/// high valence, strips, random triangulations, pieces of the wing in tests/data), bent, folded, stretched, graded, pinched
/// and moved; sometimes several of them.
/// @param extent 0 … 1: counts of cells along a side come up to this share of the largest
/// @returns a valid surface, as check_input() accepts it; empty if none could be made
shapes::Shape make_surface(ByteSource& source, double extent);

/// Changes that make a surface invalid in all the ways that check_input() knows, or in none.
void spoil(shapes::Shape& shape, ByteSource& source);

}  // namespace anisoquad::generated
