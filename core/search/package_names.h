#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace rocinante {

class SearchFacts;

/// The package names that folders declare in their package.xml. Looks at each folder once. Any
/// number of threads at once.
class PackageNames {
 public:
  /// Notes in `facts` what is looked at from now on; borrowed.
  void noteIn(SearchFacts* facts) { facts_ = facts; }

  /// The <name> in the folder's package.xml; empty where there is none that can be read.
  std::string nameOf(const std::filesystem::path& folder);
  /// The folders in `folder`, by name; at most the first 4,096 that the system lists.
  std::vector<std::filesystem::path> foldersIn(const std::filesystem::path& folder);

 private:
  SearchFacts* facts_ = nullptr;
  std::mutex mutex_;
  std::map<std::filesystem::path, std::string> names_;
  std::map<std::filesystem::path, std::vector<std::filesystem::path>> folders_;
};

}  // namespace rocinante
