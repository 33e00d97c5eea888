#pragma once

#include "anisotropy/row_stack.h"
#include "mesh/euler_operators.h"
#include "stages.h"

/// Rows as the unit cells of a plane, with its points as layers: what merge and transition start from, known exactly.
namespace anisoquad::stages {

struct GridRows : Prepared {
    int nx;
    int base;  ///< the source runs along y = base
    RowStack stack;

    GridRows(int columns, int height, int source_at, int rows)
        : Prepared(shapes::grid(columns, height),
                   {source(path(source_at * (columns + 1), source_at * (columns + 1) + columns, 1))}),
          nx(columns),
          base(source_at) {
        stack.layers.push_back(layer(0));
        for (const Vertex v : stack.layers[0]) mesh.info(v).in_row = true;
        for (int j = 1; j <= rows; ++j) add_row(j);
    }

    Vertex node(int i, int j) const { return Vertex((base + j) * (nx + 1) + i); }

    std::vector<Vertex> layer(int j) const {
        std::vector<Vertex> nodes;
        for (int i = 0; i <= nx; ++i) nodes.push_back(node(i, j));
        return nodes;
    }

    /// The quad over (or, on the other side, under) the edge from a to b.
    Face face(Vertex a, Vertex b) const { return mesh.face(mesh.find_halfedge(a, b)); }

  private:
    void add_row(int j) {
        for (int i = 0; i < nx; ++i) {
            HalfEdge diagonal = mesh.find_halfedge(node(i, j - 1), node(i + 1, j));
            if (!diagonal.is_valid()) diagonal = mesh.find_halfedge(node(i + 1, j - 1), node(i, j));
            FaceInfo& info = mesh.info(dissolve_edge(mesh, SurfaceMesh::edge(diagonal)));
            info.row = j;
            info.pass = 1;
            info.source = 0;
        }
        stack.layers.push_back(layer(j));
        stack.pass_of_row.push_back(1);
        for (const Vertex v : stack.layers[static_cast<std::size_t>(j)]) mesh.info(v).in_row = true;
    }
};

}  // namespace anisoquad::stages
