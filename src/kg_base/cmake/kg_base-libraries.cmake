# Libraries that the headers of kg_base and kg_core use: linked to every target of a package
# that finds kg_base. catkin cannot export imported targets.

find_package(absl REQUIRED)
link_libraries(absl::btree absl::flat_hash_map absl::flat_hash_set
               absl::function_ref absl::hash absl::span absl::strings)
