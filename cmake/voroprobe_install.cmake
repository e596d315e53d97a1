# `cmake --install`: the program, the libraries with their headers, and a CMake package.
#
#     find_package(voroprobe REQUIRED COMPONENTS mesher oracles)   # looks for what these need only
#     target_link_libraries(mine PRIVATE voroprobe::mesher voroprobe::oracles)
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/voroprobe)
set(header_folder ${CMAKE_INSTALL_INCLUDEDIR}/voroprobe)

install(TARGETS voroprobe RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS
        voroprobe_support voroprobe_geometry voroprobe_volume voroprobe_mesh voroprobe_oracles voroprobe_mesher
        voroprobe_certificate voroprobe_io voroprobe_labels
    EXPORT voroprobe
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})

# What users include; all else is detail. Headers keep their folders: "mesh/topology.h", "io/mesh_writer.h".
set(public_headers
    src/support/error.h src/support/progress.h
    src/geometry/vec3.h src/geometry/segment3.h src/geometry/box3.h src/geometry/affine_transform.h
    src/geometry/oriented_point.h
    src/volume/region.h src/volume/neck.h src/volume/surface_point.h src/volume/level.h src/volume/grid_geometry.h src/volume/volume.h src/volume/statistics.h
    src/volume/lattice_frame.h src/volume/height_field.h src/volume/region_runs.h src/volume/inventory.h
    src/mesh/triangle_mesh.h src/mesh/topology.h src/mesh/measures.h src/mesh/mesh_part.h
    oracles/surface_oracle.h oracles/trilinear_oracle.h oracles/vdb_oracle.h oracles/implicit_oracle.h
    oracles/implicit_domain.h oracles/implicit_expression.h oracles/scalar_field.h
    oracles/parametric_oracle.h oracles/point_cloud_oracle.h oracles/sphere_union_oracle.h oracles/triangle_mesh_oracle.h
    src/mesher/meshing_options.h src/mesher/seeded_mesher.h
    src/certificate/certificate.h src/certificate/criteria_exceptions.h src/certificate/mesh_check.h src/certificate/mesh_pieces.h
    src/certificate/nearest_crossing.h src/certificate/self_intersections.h src/certificate/surface_distance.h
    src/labels/group_meshing.h src/labels/index_box.h src/labels/joint_meshing.h src/labels/label_meshing.h src/labels/label_survey.h src/labels/part_groups.h
    src/labels/smoothing.h
    io/label_table.h io/volume_reader.h io/mesh_writer.h io/mesh_reader.h)
foreach(header ${public_headers})
    cmake_path(GET header PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    install(FILES ${header} DESTINATION ${header_folder}/${folder})
endforeach()

install(EXPORT voroprobe NAMESPACE voroprobe:: FILE voroprobeTargets.cmake DESTINATION ${package_folder})
configure_package_config_file(cmake/voroprobeConfig.cmake.in ${PROJECT_BINARY_DIR}/voroprobeConfig.cmake
    INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/voroprobeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/voroprobeConfig.cmake ${PROJECT_BINARY_DIR}/voroprobeConfigVersion.cmake
    DESTINATION ${package_folder})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
