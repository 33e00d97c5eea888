#include "cad/read_shape.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <cctype>
#include <mutex>
#include <sstream>
#include <string>

#include "errors.h"

namespace anisoquad::cad {
namespace {

constexpr double kSewing = 1e-4;  ///< mm; gaps that IGES files of good quality have

[[noreturn]] void fail(const std::string& what, const std::string& why) {
    throw Error(ErrorCode::invalid_shape, what + ": " + why);
}

/// The readers keep what they read in globals, and talk on standard output.
class Session {
  public:
    Session() : lock_(mutex()) { Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream)); }

  private:
    static std::mutex& mutex() {
        static std::mutex one;
        return one;
    }
    std::lock_guard<std::mutex> lock_;
};

template <class Reader>
TopoDS_Shape transfer(const std::filesystem::path& path, const char* format) {
    Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) fail(path.string(), std::string("not a valid ") + format + " file");
    reader.TransferRoots();
    return reader.NbShapes() > 0 ? reader.OneShape() : TopoDS_Shape();
}

TopoDS_Shape sewn(const TopoDS_Shape& shape) {
    BRepBuilderAPI_Sewing sewing(kSewing);
    sewing.Add(shape);
    sewing.Perform();
    return sewing.SewedShape();
}

TopoDS_Shape read_by_suffix(const std::filesystem::path& path) {
    std::string suffix = path.extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix == ".step" || suffix == ".stp") return transfer<STEPControl_Reader>(path, "STEP");
    if (suffix == ".iges" || suffix == ".igs") {
        const TopoDS_Shape shape = transfer<IGESControl_Reader>(path, "IGES");
        return shape.IsNull() ? shape : sewn(shape);
    }
    if (suffix == ".brep" || suffix == ".brp") {
        TopoDS_Shape shape;
        const BRep_Builder builder;
        if (!BRepTools::Read(shape, path.c_str(), builder)) fail(path.string(), "not a valid BREP file");
        return shape;
    }
    fail(path.string(), "can only read .step, .stp, .iges, .igs, .brep and .brp");
}

}  // namespace

TopoDS_Shape read_brep(std::string_view text) {
    std::istringstream stream{std::string(text)};
    TopoDS_Shape shape;
    try {
        BRepTools::Read(shape, stream, BRep_Builder());
    } catch (const Standard_Failure& failure) {
        fail("The shape", std::string("its BREP can't be read: ") + failure.GetMessageString());
    }
    if (shape.IsNull()) fail("The shape", "it is empty, or its BREP can't be read");
    return shape;
}

TopoDS_Shape read_shape(const std::filesystem::path& path) {
    const Session session;
    if (!std::filesystem::is_regular_file(path)) fail(path.string(), "No such file or directory");
    TopoDS_Shape shape;
    try {
        shape = read_by_suffix(path);
    } catch (const Standard_Failure& failure) {
        fail(path.string(), std::string("can't be read: ") + failure.GetMessageString());
    }
    if (shape.IsNull()) fail(path.string(), "holds no shape");
    return shape;
}

}  // namespace anisoquad::cad
