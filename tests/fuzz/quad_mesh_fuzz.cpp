#include <cstdio>
#include <cstdlib>

#include "generated/run_case.h"

/// libFuzzer's target: bytes become a surface, sources and options, good or bad, and go through the whole pipeline.
/// With ANISOQUAD_FUZZ_PRINT the case is written to stdout as an OFF file first.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace anisoquad::generated;
    ByteSource source({data, size});
    const MeshCase mesh_case = make_case(source, true);
    if (std::getenv("ANISOQUAD_FUZZ_PRINT")) {
        std::fputs(to_text(mesh_case).c_str(), stdout);
        std::fflush(stdout);  // a case that fails aborts
    }
    const Outcome outcome = run_case(mesh_case);
    if (!outcome.failure.empty()) {
        std::fprintf(stderr, "FAILURE: %s\n", outcome.failure.c_str());
        std::abort();
    }
    return 0;
}
