# Lists the files that `cmake --install` installs. find_package(tendon COMPONENTS core network ice eigen) finds them.
# Each part is a separate install component: core, network, ice, eigen, hdf5, programs, plugins, gui,
# python. The target `installed` builds all of these parts and no tests.
include(CMakePackageConfigHelpers)

set(package lib/cmake/tendon)
add_custom_target(installed)

# Installs tendon::NAME, its headers, and the file that describes it to find_package().
function(install_library name)
  install(TARGETS tendon_${name} EXPORT tendon_${name}
    LIBRARY DESTINATION lib COMPONENT ${name} NAMELINK_COMPONENT ${name}
    FILE_SET HEADERS DESTINATION include COMPONENT ${name})
  install(EXPORT tendon_${name}
    FILE tendon-${name}.cmake NAMESPACE tendon:: DESTINATION ${package} COMPONENT ${name})
endfunction()

foreach(name core network ice)
  if(TARGET tendon_${name})
    set_target_properties(tendon_${name} PROPERTIES INSTALL_RPATH $ORIGIN)
    install_library(${name})
    add_dependencies(installed tendon_${name})
  endif()
endforeach()
install_library(eigen)

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
  set_target_properties(gcm-gui PROPERTIES INSTALL_RPATH $ORIGIN/../lib)
  install(TARGETS gcm-gui RUNTIME DESTINATION bin COMPONENT gui)
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

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/tendon-config.cmake.in
  ${PROJECT_BINARY_DIR}/tendon-config.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/tendon-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/tendon-config.cmake ${PROJECT_BINARY_DIR}/tendon-config-version.cmake
  DESTINATION ${package} COMPONENT core)

# The contract is a symbolic link in the package; the file that it points to is installed.
if(TARGET tendon_ice)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/resources/python/tendon DESTINATION share/tendon/python COMPONENT python
    FILES_MATCHING PATTERN "*.py" PATTERN messages.txt PATTERN __pycache__ EXCLUDE)
  install(FILES ${PROJECT_SOURCE_DIR}/core/tendon/ice/tendon.ice
    DESTINATION share/tendon/python/tendon/middleware COMPONENT python)
endif()
