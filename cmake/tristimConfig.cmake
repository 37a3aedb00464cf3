# tristim::tristim, and tristim::io for pictures and frames in files; COMPONENTS may name io.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3)
include("${CMAKE_CURRENT_LIST_DIR}/tristimTargets.cmake")

set(tristim_io_FOUND TRUE)
foreach(component IN LISTS tristim_FIND_COMPONENTS)
  if(NOT tristim_${component}_FOUND AND tristim_FIND_REQUIRED_${component})
    set(tristim_FOUND FALSE)
    set(tristim_NOT_FOUND_MESSAGE "tristim has no component ${component}; the only one is io")
  endif()
endforeach()
