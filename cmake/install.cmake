# Lists the files that `cmake --install` installs. find_package(tendon COMPONENTS core network ice eigen) finds them.
# Each part is a separate install component: core, network, ice, eigen, hdf5, programs, plugins, gui,
# python. The target `installed` builds all of these parts and no tests.
include(CMakePackageConfigHelpers)

set(package lib/cmake/tendon)
add_custom_target(installed)

# tendon_install_library(NAME PURPOSE [LIBS "LINKER FLAGS"] [REQUIRES "PACKAGES"]): installs tendon::NAME, its headers,
# and the files that describe it to find_package() and to pkg-config.
function(tendon_install_library name purpose)
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "LIBS;REQUIRES" "")
  set(libs ${arg_LIBS})
  set(requires ${arg_REQUIRES})
  configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/tendon.pc.in ${PROJECT_BINARY_DIR}/tendon-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/tendon-${name}.pc DESTINATION lib/pkgconfig COMPONENT ${name})
  install(TARGETS tendon_${name} EXPORT tendon_${name}
    LIBRARY DESTINATION lib COMPONENT ${name} NAMELINK_COMPONENT ${name}
    FILE_SET HEADERS DESTINATION include COMPONENT ${name})
  install(EXPORT tendon_${name}
    FILE tendon-${name}.cmake NAMESPACE tendon:: DESTINATION ${package} COMPONENT ${name})
endfunction()

tendon_install_library(core "the components of one process"
  LIBS "-L\${libdir} -ltendon_core -pthread")
tendon_install_library(network "processes that talk to each other"
  LIBS "-L\${libdir} -ltendon_network" REQUIRES "tendon-core = ${PROJECT_VERSION}")
tendon_install_library(eigen "vectors and matrices of Eigen"
  REQUIRES "tendon-core = ${PROJECT_VERSION}, eigen3 >= 3.4")
if(TARGET tendon_ice)
  tendon_install_library(ice "the network over ZeroC Ice"
    LIBS "-L\${libdir} -ltendon_ice" REQUIRES "tendon-network = ${PROJECT_VERSION}")
endif()
foreach(name core network ice)
  if(TARGET tendon_${name})
    set_target_properties(tendon_${name} PROPERTIES INSTALL_RPATH $ORIGIN)
    add_dependencies(installed tendon_${name})
  endif()
endforeach()

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tendon-config.cmake.in
  ${PROJECT_BINARY_DIR}/tendon-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tendon-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tendon-config.cmake ${PROJECT_BINARY_DIR}/tendon-config-version.cmake
  DESTINATION ${package} COMPONENT core)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/tendon COMPONENT core)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/licences DESTINATION share/doc/tendon COMPONENT core)

# The contract is a symbolic link in the package; the file that it points to is installed.
if(TARGET tendon_ice)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/python/tendon DESTINATION share/tendon/python COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN messages.txt PATTERN __pycache__ EXCLUDE)
  install(FILES ${PROJECT_SOURCE_DIR}/core/tendon/ice/tendon.ice
    DESTINATION share/tendon/python/tendon/middleware COMPONENT python)
endif()

if(NOT TENDON_WITH_PROGRAMS)
  return()
endif()

if(TARGET tendon_hdf5)
  set_target_properties(tendon_hdf5 PROPERTIES INSTALL_RPATH $ORIGIN/..)
  install(TARGETS tendon_hdf5 LIBRARY DESTINATION lib/tendon COMPONENT hdf5)
  add_dependencies(installed tendon_hdf5)
endif()

foreach(program lcm gcm tendon-probe)
  set_target_properties(${program} PROPERTIES INSTALL_RPATH $ORIGIN/../lib)
  install(TARGETS ${program} RUNTIME DESTINATION bin COMPONENT programs)
  add_dependencies(installed ${program})
endforeach()
get_target_property(pages gcm_pages PAGES)
install(DIRECTORY ${pages}/man1 DESTINATION share/man COMPONENT programs)
install(FILES ${pages}/gcm DESTINATION share/bash-completion/completions COMPONENT programs)
install(FILES ${pages}/_gcm DESTINATION share/zsh/site-functions COMPONENT programs)
install(FILES ${pages}/gcm.fish DESTINATION share/fish/vendor_completions.d COMPONENT programs)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/systemd DESTINATION share/tendon COMPONENT programs)
install(FILES ${PROJECT_SOURCE_DIR}/resources/systems/demo.json DESTINATION share/tendon/systems COMPONENT programs)
add_dependencies(installed gcm_pages)
if(TARGET gcm-gui)
  set_target_properties(gcm-gui PROPERTIES INSTALL_RPATH "$ORIGIN/../lib;$ORIGIN/../lib/tendon")
  install(TARGETS gcm-gui RUNTIME DESTINATION bin COMPONENT gui)
  # The loader finds only the Qwt of the system, so another one is installed as well. Its folder is private, because a
  # Qwt for Qt 5 has the same name.
  get_target_property(qwt gcm-gui QWT_LIBRARY)
  cmake_path(GET qwt PARENT_PATH folder)
  if(qwt AND NOT folder IN_LIST CMAKE_CXX_IMPLICIT_LINK_DIRECTORIES)
    file(GLOB files ${qwt}.*)  # libqwt.so.6.3 and what it links to
    install(FILES ${files} DESTINATION lib/tendon COMPONENT gui)
  endif()
  set(desktop ${PROJECT_SOURCE_DIR}/resources/desktop/org.tendon.GcmGui)
  install(FILES ${desktop}.desktop DESTINATION share/applications COMPONENT gui)
  install(FILES ${desktop}.svg DESTINATION share/icons/hicolor/scalable/apps COMPONENT gui)
  install(FILES ${desktop}.metainfo.xml DESTINATION share/metainfo COMPONENT gui)
  install(FILES ${desktop}.mime.xml DESTINATION share/mime/packages RENAME org.tendon.GcmGui.xml COMPONENT gui)
  add_dependencies(installed gcm-gui)
endif()

get_property(plugins GLOBAL PROPERTY TENDON_PLUGINS)
foreach(plugin ${plugins})
  set_target_properties(${plugin} PROPERTIES INSTALL_RPATH $ORIGIN/../..)
  install(TARGETS ${plugin} LIBRARY DESTINATION lib/tendon/components COMPONENT plugins)
  add_dependencies(installed ${plugin})
endforeach()
