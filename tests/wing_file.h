#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace anisoquad {

/// A wing of tests/data: its triangles, and the ids of its leading edge's nodes in order.
struct WingFile {
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::int32_t, 3>> triangles;
    std::vector<std::int32_t> leading_edge;
};

/// @param path of its files, without .off and .json
inline WingFile read_wing_file(const std::string& path) {
    WingFile wing;
    std::ifstream off(path + ".off");
    std::string magic;
    std::size_t points = 0;
    std::size_t triangles = 0;
    int count = 0;
    off >> magic >> points >> triangles >> count;
    wing.points.resize(points);
    for (auto& p : wing.points) off >> p.x() >> p.y() >> p.z();
    wing.triangles.resize(triangles);
    for (auto& t : wing.triangles) off >> count >> t[0] >> t[1] >> t[2];
    std::ifstream json(path + ".json");
    json.ignore(std::numeric_limits<std::streamsize>::max(), '[');
    char separator = ',';
    for (std::int32_t id = 0; separator == ',' && json >> id >> separator;) wing.leading_edge.push_back(id);
    return wing;
}

}  // namespace anisoquad
