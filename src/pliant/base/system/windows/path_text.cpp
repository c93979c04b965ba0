// SPDX-License-Identifier: MIT
#include "pliant/base/system/path_text.hpp"

#include <windows.h>
// After windows.h.
#include <shellapi.h>

#include <cstdlib>
#include <memory>

namespace pliant {
namespace {

std::string narrow(std::wstring_view wide) {
  if (wide.empty()) return "";
  const int count = static_cast<int>(wide.size());
  const auto convert = [&](char* into, int room) {
    return ::WideCharToMultiByte(CP_UTF8, 0, wide.data(), count, into, room, nullptr, nullptr);
  };
  std::string text(static_cast<std::size_t>(convert(nullptr, 0)), '\0');
  convert(text.data(), static_cast<int>(text.size()));
  return text;
}

std::wstring widen(std::string_view text) {
  if (text.empty()) return L"";
  const int count = static_cast<int>(text.size());
  const auto convert = [&](wchar_t* into, int room) {
    return ::MultiByteToWideChar(CP_UTF8, 0, text.data(), count, into, room);
  };
  std::wstring wide(static_cast<std::size_t>(convert(nullptr, 0)), L'\0');
  convert(wide.data(), static_cast<int>(wide.size()));
  return wide;
}

}  // namespace

std::string path_text(const std::filesystem::path& path) { return narrow(path.native()); }

std::filesystem::path path_of(std::string_view text) { return widen(text); }

std::vector<std::string> command_words(int, char**) {
  int count = 0;
  const std::unique_ptr<LPWSTR, decltype(&::LocalFree)> words(
      ::CommandLineToArgvW(::GetCommandLineW(), &count), ::LocalFree);
  std::vector<std::string> texts;
  for (int k = 1; words && k < count; ++k) texts.push_back(narrow(words.get()[k]));
  return texts;
}

std::string environment(const char* name) {
  const wchar_t* value = ::_wgetenv(widen(name).c_str());
  return value == nullptr ? "" : narrow(value);
}

}  // namespace pliant
