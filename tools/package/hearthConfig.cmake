# find_package(hearth) gives hearth::engine, and a target of the name of each of its folders.
include(CMakeFindDependencyMacro)
find_dependency(fmt)
find_dependency(hwy)
find_dependency(tl-expected)
find_dependency(ZLIB)
include(${CMAKE_CURRENT_LIST_DIR}/hearthTargets.cmake)
