# Finds Qwt 6.3 for Qt 6, makes the target Qwt::Qwt, and sets Qwt_LIBRARY to its file. Uses the first one found, in this
# order:
#   1. the system's package (pkg-config Qt6Qwt6),
#   2. Qwt_ROOT, a variable of CMake or of the environment: a folder with include/ and lib/,
#   3. the cache in which tools/setup builds it on systems that package Qwt for Qt 5 only.
# The system's folders are never searched, because they may contain a Qwt for Qt 5.

find_package(Qt6 REQUIRED COMPONENTS Widgets)
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(Qt6Qwt6 QUIET IMPORTED_TARGET Qt6Qwt6)
endif()

if(Qt6Qwt6_FOUND)
  set(Qwt_VERSION ${Qt6Qwt6_VERSION})
  set(Qwt_LIBRARY ${Qt6Qwt6_LINK_LIBRARIES})
  list(FILTER Qwt_LIBRARY INCLUDE REGEX "/libqwt[^/]*$")
  set(required_variables Qt6Qwt6_FOUND)
else()
  include(${CMAKE_CURRENT_LIST_DIR}/tendon_cache.cmake)
  set(places ${Qwt_ROOT} $ENV{Qwt_ROOT} ${TENDON_CACHE}/qwt-6.3.0)

  find_path(Qwt_INCLUDE_DIR qwt_plot.h PATHS ${places}
    PATH_SUFFIXES include include/qwt include/qwt6 include/qwt6-qt6 NO_DEFAULT_PATH)
  find_library(Qwt_LIBRARY NAMES qwt-qt6 qwt PATHS ${places} PATH_SUFFIXES lib NO_DEFAULT_PATH)
  set(required_variables Qwt_LIBRARY Qwt_INCLUDE_DIR)
  mark_as_advanced(Qwt_INCLUDE_DIR Qwt_LIBRARY)
  if(Qwt_INCLUDE_DIR)
    file(STRINGS ${Qwt_INCLUDE_DIR}/qwt_global.h version REGEX "define +QWT_VERSION_STR")
    string(REGEX REPLACE ".*\"(.*)\".*" "\\1" Qwt_VERSION "${version}")
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Qwt
  REQUIRED_VARS ${required_variables}
  VERSION_VAR Qwt_VERSION
  REASON_FAILURE_MESSAGE "Run tools/setup, or set Qwt_ROOT to a Qwt 6.3 for Qt 6.")

if(Qwt_FOUND AND NOT TARGET Qwt::Qwt)
  if(Qt6Qwt6_FOUND)
    add_library(Qwt::Qwt INTERFACE IMPORTED)
    target_link_libraries(Qwt::Qwt INTERFACE PkgConfig::Qt6Qwt6 Qt6::Widgets)
  else()
    add_library(Qwt::Qwt SHARED IMPORTED)
    set_target_properties(Qwt::Qwt PROPERTIES
      IMPORTED_LOCATION ${Qwt_LIBRARY}
      INTERFACE_INCLUDE_DIRECTORIES ${Qwt_INCLUDE_DIR}
      INTERFACE_COMPILE_DEFINITIONS QWT_DLL
      INTERFACE_LINK_LIBRARIES Qt6::Widgets)
  endif()
endif()
