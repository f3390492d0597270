#include <tendon/recording/hdf5/hdf5_export.h>

#include <tendon/base/os/shared_library.h>
#include <tendon/base/text.h>
#include <tendon/recording/hdf5/hdf5_module.h>

#include <system_error>

namespace tendon::recording {
namespace {

/// In the folder `tendon` beside this library.
std::filesystem::path ModuleFile() {
  const auto self = os::FileOf(reinterpret_cast<const void*>(&ModuleFile));
  return self.parent_path() / "tendon" / "tendon_hdf5.so";
}

}  // namespace

Result<LoadedHdf5Module> LoadHdf5Module(const std::filesystem::path& file) {
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) {
    return Error{ErrorCode::kNotFound, "there is no " + file.string() +
                                           ", which is needed to write HDF5: install libhdf5-dev "
                                           "and build Tendon again, or export CSV"};
  }
  const auto library = os::LoadSharedLibrary(file, file);
  if (!library) return Error{library.error().code, file.string() + ": " + library.error().message};
  void* const build = os::FindSymbol(*library, kHdf5BuildSymbol);
  void* const write = os::FindSymbol(*library, kHdf5Symbol);
  const std::string expected = Hdf5Build();
  const std::string found =
      build == nullptr ? "none" : Printable(reinterpret_cast<Hdf5ModuleBuild*>(build)(), 200);
  if (write == nullptr || found != expected) {
    return Error{ErrorCode::kInvalid,
                 file.string() + " belongs to another build of Tendon (expected " + expected +
                     "; found " + found + "): install or build all of Tendon again, or export CSV"};
  }
  return LoadedHdf5Module{reinterpret_cast<Hdf5Module*>(write)};
}

Result<Hdf5Report> ExportHdf5(mcap::Reader& reader, const mcap::Query& query,
                              const std::filesystem::path& file, const os::StopRequest& stop) {
  static const Result<LoadedHdf5Module> module = LoadHdf5Module(ModuleFile());
  if (!module) return module.error();
  Result<Hdf5Report> report(Hdf5Report{});
  module->write(reader, query, file, stop, report);
  return report;
}

}  // namespace tendon::recording
