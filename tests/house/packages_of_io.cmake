# CMake options that make a machine look as if it had none of the packages that only io needs.
set(without_packages_of_io)
foreach(package PkgConfig PNG SQLite3 nlohmann_json)
  list(APPEND without_packages_of_io -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
