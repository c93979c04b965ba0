// SPDX-License-Identifier: MIT
#include "corpus/corpus.hpp"
#include "support/source_folder.hpp"

#include <fstream>
#include <sstream>

namespace pliant {

std::filesystem::path corpus_folder(const std::string& name) {
  return source_folder() / "tests" / "corpus" / name;
}

std::vector<CorpusCase> corpus_cases(const std::string& folder) {
  std::ifstream in(corpus_folder(folder) / "expected.txt");
  std::vector<CorpusCase> cases;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("== ")) {
      std::istringstream words(line.substr(3));
      CorpusCase next{folder, "", 1, ""};
      std::string word;
      words >> next.file;
      if (words >> word) words >> next.model;
      cases.push_back(next);
    } else if (!cases.empty() && !line.starts_with("#") && !line.empty()) {
      cases.back().expected += line + "\n";
    }
  }
  return cases;
}

}  // namespace pliant
