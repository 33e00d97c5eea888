#include "cleanup/patch_mesh.h"

#include <algorithm>

namespace anisoquad {
namespace {

using Line = std::vector<Vertex>;

class PatchMesher {
  public:
    PatchMesher(const SurfaceMesh& mesh, PatchPlanner& planner, double size) : mesh_(mesh), planner_(planner), size_(size) {}

    void fill(const std::vector<Line>& sides, int budget) {
        Sides counts;
        for (const Line& side : sides) counts.push_back(static_cast<int>(side.size()) - 1);
        const PatchPlan plan = planner_.plan(counts, budget);
        assert(plan.is_possible());
        if (plan.cut) {
            fill_pieces(sides, plan);
        } else if (sides.size() == 4) {
            fill_grid(sides);
        } else {
            fill_star(sides, counts);
        }
    }

    Replacement take() { return std::move(result_); }

  private:
    Point place(Vertex v) const {
        return Replacement::is_new(v) ? result_.nodes[Replacement::index(v)].place : mesh_.position(v);
    }

    Vertex add(const Point& p) {
        VertexInfo info;
        info.size = size_;
        result_.nodes.push_back({p, info});
        return Replacement::new_node(result_.nodes.size() - 1);
    }

    /// New nodes on the straight line between two nodes.
    Line straight(Vertex a, Vertex b, int edges) {
        Line line{a};
        for (int k = 1; k < edges; ++k) {
            const double t = static_cast<double>(k) / edges;
            line.push_back(add((1.0 - t) * place(a) + t * place(b)));
        }
        line.push_back(b);
        return line;
    }

    static Line reversed(Line line) {
        std::reverse(line.begin(), line.end());
        return line;
    }
    static Line part(const Line& line, int from, int to) { return {line.begin() + from, line.begin() + to + 1}; }

    void fill_pieces(const std::vector<Line>& sides, const PatchPlan& plan) {
        const Line& start = sides[static_cast<std::size_t>(plan.i)];
        const Line& end = sides[static_cast<std::size_t>(plan.j) % sides.size()];
        const Line cut = straight(start[static_cast<std::size_t>(plan.p)], end[static_cast<std::size_t>(plan.q)], plan.r);
        std::vector<Line> left{part(start, plan.p, static_cast<int>(start.size()) - 1)};
        for (int k = plan.i + 1; k < plan.j; ++k) left.push_back(sides[static_cast<std::size_t>(k) % sides.size()]);
        left.push_back(part(end, 0, plan.q));
        left.push_back(reversed(cut));
        std::vector<Line> right{part(end, plan.q, static_cast<int>(end.size()) - 1)};
        for (std::size_t k = static_cast<std::size_t>(plan.j) + 1; k < static_cast<std::size_t>(plan.i) + sides.size(); ++k) {
            right.push_back(sides[k % sides.size()]);
        }
        right.push_back(part(start, 0, plan.p));
        right.push_back(cut);
        fill(left, plan.left_budget);
        fill(right, plan.right_budget);
    }

    /// One irregular node, from which an arm goes to every side.
    void fill_star(const std::vector<Line>& sides, const Sides& counts) {
        const std::size_t n = sides.size();
        PatchPlanner::Arms arms{};
        [[maybe_unused]] const bool found = PatchPlanner::find_arms(counts, arms);
        assert(found);
        const auto none = std::find(arms.begin(), arms.begin() + static_cast<std::ptrdiff_t>(n), 0);
        if (none != arms.begin() + static_cast<std::ptrdiff_t>(n)) {
            fill_corner_grid(sides, static_cast<std::size_t>(none - arms.begin()));
            return;
        }
        // Side i is divided by its arm: the part behind its first corner is as long as arm i−1, the rest as arm i+1.
        Point middle = Point::Zero();
        std::vector<Vertex> feet;
        for (std::size_t i = 0; i < n; ++i) {
            feet.push_back(sides[i][static_cast<std::size_t>(arms[(i + n - 1) % n])]);
            middle += place(feet.back()) / static_cast<double>(n);
        }
        const Vertex centre = add(middle);
        std::vector<Line> arm_lines;
        for (std::size_t i = 0; i < n; ++i) arm_lines.push_back(straight(feet[i], centre, arms[i]));
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t last = (i + n - 1) % n;
            // The block at corner i, from the foot on the side before it.
            const auto foot = static_cast<int>(arms[(last + n - 1) % n]);
            fill_grid({part(sides[last], foot, static_cast<int>(sides[last].size()) - 1), part(sides[i], 0, arms[last]),
                       arm_lines[i], reversed(arm_lines[last])});
        }
    }

    /// A triangle whose irregular node lies on the side `with_corner`.
    void fill_corner_grid(const std::vector<Line>& sides, std::size_t with_corner) {
        const Line& divided = sides[with_corner];
        const Line& second = sides[(with_corner + 1) % 3];
        const Line& third = sides[(with_corner + 2) % 3];
        const auto corner = static_cast<int>(second.size()) - 1;
        fill_grid({part(divided, 0, corner), part(divided, corner, static_cast<int>(divided.size()) - 1), second, third});
    }

    /// Transfinite interpolation.
    void fill_grid(const std::vector<Line>& sides) {
        const std::size_t nx = sides[0].size();
        const std::size_t ny = sides[1].size();
        const auto bottom = [&](std::size_t i) { return sides[0][i]; };
        const auto right = [&](std::size_t j) { return sides[1][j]; };
        const auto top = [&](std::size_t i) { return sides[2][nx - 1 - i]; };
        const auto left = [&](std::size_t j) { return sides[3][ny - 1 - j]; };
        std::vector<Vertex> grid(nx * ny);
        for (std::size_t j = 0; j < ny; ++j) {
            for (std::size_t i = 0; i < nx; ++i) {
                Vertex& v = grid[j * nx + i];
                if (j == 0) {
                    v = bottom(i);
                } else if (j == ny - 1) {
                    v = top(i);
                } else if (i == 0) {
                    v = left(j);
                } else if (i == nx - 1) {
                    v = right(j);
                } else {
                    const double x = static_cast<double>(i) / static_cast<double>(nx - 1);
                    const double y = static_cast<double>(j) / static_cast<double>(ny - 1);
                    v = add((1.0 - y) * place(bottom(i)) + y * place(top(i)) + (1.0 - x) * place(left(j)) + x * place(right(j)) -
                            ((1.0 - x) * (1.0 - y) * place(bottom(0)) + x * (1.0 - y) * place(bottom(nx - 1)) +
                             x * y * place(top(nx - 1)) + (1.0 - x) * y * place(top(0))));
                }
            }
        }
        for (std::size_t j = 0; j + 1 < ny; ++j) {
            for (std::size_t i = 0; i + 1 < nx; ++i) {
                const std::size_t k = j * nx + i;
                result_.quads.push_back({grid[k], grid[k + 1], grid[k + nx + 1], grid[k + nx]});
            }
        }
    }

    const SurfaceMesh& mesh_;
    PatchPlanner& planner_;
    double size_;
    Replacement result_;
};

}  // namespace

Replacement mesh_patch(const SurfaceMesh& mesh, PatchPlanner& planner, std::vector<std::vector<Vertex>> sides, int budget,
                       double size) {
    PatchMesher mesher(mesh, planner, size);
    mesher.fill(sides, budget);
    return mesher.take();
}

}  // namespace anisoquad
