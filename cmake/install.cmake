include(CMakePackageConfigHelpers)

install(TARGETS tristim tristim_io EXPORT tristim LIBRARY FILE_SET HEADERS)
install(TARGETS tristim_command)
install(TARGETS tristim_oiio tristim_openexr tristim_ocio LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/tristim")
install(DIRECTORY luts DESTINATION "${CMAKE_INSTALL_DATADIR}/tristim")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/tristim")
install(EXPORT tristim NAMESPACE tristim:: FILE tristimTargets.cmake DESTINATION "${package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/tristimConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES cmake/tristimConfig.cmake "${PROJECT_BINARY_DIR}/tristimConfigVersion.cmake"
  DESTINATION "${package_dir}")

# The .pc files find the rest from where they lie, so the installed tree may be moved.
set(pc_dir "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig")
file(RELATIVE_PATH prefix_from_pc "${pc_dir}" "${CMAKE_INSTALL_PREFIX}")
file(RELATIVE_PATH libdir_from_prefix "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_LIBDIR}")
file(RELATIVE_PATH includedir_from_prefix
  "${CMAKE_INSTALL_PREFIX}" "${CMAKE_INSTALL_FULL_INCLUDEDIR}")
foreach(name tristim tristim-io)
  configure_file("cmake/${name}.pc.in" "${PROJECT_BINARY_DIR}/${name}.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/${name}.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
endforeach()
