#include <tendon/base/os/shared_library.h>
#include <tendon/recording/hdf5_export.h>
#include <tendon/recording/hdf5_module.h>

#include <system_error>

namespace tendon::recording {
namespace {

struct Module {
  Hdf5Module* write = nullptr;
};

/// Loads the module from the folder `tendon` beside this library.
Result<Module> LoadModule() {
  const auto self = os::FileOf(reinterpret_cast<const void*>(&LoadModule));
  const auto file = self.parent_path() / "tendon" / "tendon_hdf5.so";
  std::error_code failed;
  if (!std::filesystem::exists(file, failed)) {
    return Error{ErrorCode::kNotFound, "there is no " + file.string() +
                                           ", which is needed to write HDF5: install libhdf5-dev "
                                           "and build Tendon again, or export CSV"};
  }
  const auto library = os::LoadSharedLibrary(file, file);
  if (!library) return Error{library.error().code, file.string() + ": " + library.error().message};
  void* const symbol = os::FindSymbol(*library, kHdf5Symbol);
  if (symbol == nullptr) {
    return Error{ErrorCode::kInvalid, file.string() + " belongs to another version of Tendon"};
  }
  return Module{reinterpret_cast<Hdf5Module*>(symbol)};
}

}  // namespace

Result<Hdf5Report> ExportHdf5(mcap::Reader& reader, const mcap::Query& query,
                              const std::filesystem::path& file) {
  static const Result<Module> module = LoadModule();
  if (!module) return module.error();
  Result<Hdf5Report> report(Hdf5Report{});
  module->write(reader, query, file, report);
  return report;
}

}  // namespace tendon::recording
