#include "options.h"

#include "errors.h"

namespace anisoquad {

std::vector<Pass> passes_for_anisotropy(int anisotropy) {
    if (anisotropy < 1) {
        throw Error(ErrorCode::invalid_option, "The maximum anisotropy must be 1 or more.");
    }
    std::vector<Pass> passes;
    if (anisotropy == 1) return passes;
    if (anisotropy <= 5) return {Pass{anisotropy, 0}};
    // The last pass is 1:2 (paper 3.3); what remains is split into a first pass of at most 1:4 and further ones of 1:2.
    int rest = (anisotropy + 1) / 2;
    int halvings = 1;
    while (rest > 5) {
        rest = (rest + 1) / 2;
        ++halvings;
    }
    passes.push_back({rest, 0});
    for (int i = 0; i < halvings; ++i) passes.push_back({2, 0});
    return passes;
}

}  // namespace anisoquad
