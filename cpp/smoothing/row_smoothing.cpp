#include "smoothing/row_smoothing.h"
namespace anisoquad { RowSmoothingResult smooth_rows(SurfaceMesh&, const ReferenceSurface*, int){return {};} }
