#pragma once

#include <tendon/base/cxx_abi.h>
#include <tendon/recording/hdf5/hdf5_export.h>

#include <cstddef>
#include <string>

namespace tendon::recording {

/// The function that the module tendon_hdf5 exports. Only ExportHdf5() calls it. The module is the
/// only part of Tendon that uses HDF5, because HDF5 needs 30 other libraries, and programs should
/// load them only if necessary.
using Hdf5Module = void(mcap::Reader& reader, const mcap::Query& query,
                        const std::filesystem::path& file, const os::StopRequest& stop,
                        Result<Hdf5Report>& report);
inline constexpr const char* kHdf5Symbol = "TendonExportHdf5";
/// A function that returns Hdf5Build() of the module. The program and the module exchange objects,
/// so a module of another build must not be called.
using Hdf5ModuleBuild = const char*();
inline constexpr const char* kHdf5BuildSymbol = "TendonHdf5Build";

/// Returns the properties that must be equal in the program and the module: the version of
/// Hdf5Module, the ABI of the compiler, and the layout of the objects.
[[nodiscard]] inline std::string Hdf5Build() {
  std::string text = "module 1, C++ ABI " + std::to_string(kCxxAbi) + "." +
                     std::to_string(kCxxLibraryAbi) + ", layout";
  for (const std::size_t size : {sizeof(mcap::Reader), sizeof(mcap::MessageStream),
                                 sizeof(mcap::Query), sizeof(mcap::Channel), sizeof(Hdf5Report)}) {
    text += " " + std::to_string(size);
  }
  return text;
}

struct LoadedHdf5Module {
  Hdf5Module* write = nullptr;
};

/// Loads the module. Fails with kNotFound if there is no such file, and with kInvalid if it belongs
/// to another build.
[[nodiscard]] Result<LoadedHdf5Module> LoadHdf5Module(const std::filesystem::path& file);

}  // namespace tendon::recording
