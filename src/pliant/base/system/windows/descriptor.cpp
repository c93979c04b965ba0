// SPDX-License-Identifier: MIT
#include "pliant/base/system/descriptor.hpp"

#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

#include "pliant/base/system/windows/windows_errors_internal.hpp"
#include "pliant/base/system/windows/windows_handles_internal.hpp"

namespace pliant {
namespace {

constexpr DWORD all_may = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;

DWORD how_of(Opening opening) {
  if (opening == Opening::to_make) return OPEN_ALWAYS;
  return opening == Opening::to_make_anew ? CREATE_NEW : OPEN_EXISTING;
}

/// Not to be renamed by this handle (DELETE): HDF5, whose opening of a file does not agree to that,
/// could not read beside it.
HANDLE open_handle(const wchar_t* path, Opening opening) {
  const DWORD access = opening == Opening::to_read ? GENERIC_READ : GENERIC_READ | GENERIC_WRITE;
  // A folder opens as well, so that messages can say that it is one.
  const DWORD flags = FILE_ATTRIBUTE_NORMAL | FILE_FLAG_BACKUP_SEMANTICS |
                      (opening == Opening::to_make ? FILE_FLAG_OPEN_REPARSE_POINT : 0);
  return ::CreateFileW(path, access, all_may, nullptr, how_of(opening), flags, nullptr);
}

Descriptor descriptor_of(HANDLE handle, bool is_to_read) {
  const int flags = (is_to_read ? _O_RDONLY : _O_RDWR) | _O_BINARY | _O_NOINHERIT;
  Descriptor descriptor(::_open_osfhandle(reinterpret_cast<std::intptr_t>(handle), flags));
  if (!descriptor) ::CloseHandle(handle);
  return descriptor;
}

OVERLAPPED place_at(std::uint64_t position) {
  OVERLAPPED place{};
  place.Offset = static_cast<DWORD>(position);
  place.OffsetHigh = static_cast<DWORD>(position >> 32);
  return place;
}

DWORD in_one_call(std::size_t count) {
  return static_cast<DWORD>(std::min<std::size_t>(count, std::numeric_limits<int>::max()));
}

struct FileNumber {
  DWORD volume = 0;
  std::uint64_t index = 0;
  bool operator==(const FileNumber&) const = default;
};

std::optional<FileNumber> number_of_file(HANDLE handle) {
  BY_HANDLE_FILE_INFORMATION facts{};
  if (!::GetFileInformationByHandle(handle, &facts)) return std::nullopt;
  return FileNumber{facts.dwVolumeSerialNumber,
                    std::uint64_t{facts.nFileIndexHigh} << 32 | facts.nFileIndexLow};
}

FileKind kind_of(HANDLE handle, DWORD attributes) {
  if (::GetFileType(handle) == FILE_TYPE_CHAR) return FileKind::device;
  if (::GetFileType(handle) == FILE_TYPE_PIPE) return FileKind::stream;
  return attributes & FILE_ATTRIBUTE_DIRECTORY ? FileKind::folder : FileKind::regular;
}

/// Renames as POSIX does: who has the old file open keeps it, without a name.
bool replace_open(const std::filesystem::path& from, const std::filesystem::path& to) {
  const HANDLE handle = ::CreateFileW(from.c_str(), DELETE | SYNCHRONIZE, all_may, nullptr,
                                      OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (handle == INVALID_HANDLE_VALUE) return false;
  const std::wstring name = std::filesystem::absolute(to).native();
  std::vector<std::byte> room(sizeof(FILE_RENAME_INFO) + name.size() * sizeof(wchar_t));
  auto* asked = new (room.data()) FILE_RENAME_INFO{};
  asked->Flags = FILE_RENAME_FLAG_REPLACE_IF_EXISTS | FILE_RENAME_FLAG_POSIX_SEMANTICS;
  asked->FileNameLength = static_cast<DWORD>(name.size() * sizeof(wchar_t));
  std::memcpy(asked->FileName, name.c_str(), asked->FileNameLength + sizeof(wchar_t));
  const bool is_done = ::SetFileInformationByHandle(handle, FileRenameInfoEx, asked,
                                                    static_cast<DWORD>(room.size())) != 0;
  ::CloseHandle(handle);
  return is_done;
}

bool move_name(const std::filesystem::path& from, const std::filesystem::path& to, DWORD flags) {
  if (::MoveFileExW(from.c_str(), to.c_str(), flags)) return true;
  return keep_windows_error();
}

}  // namespace

std::string error_words(int error) {
  if (error == EBUSY) return "another program has it open";
  return std::generic_category().message(error);
}

void Descriptor::close() {
  if (number_ >= 0) ::_close(std::exchange(number_, -1));
}

Descriptor open_file(const std::filesystem::path& path, Opening opening) {
  const HANDLE handle = open_handle(path.c_str(), opening);
  if (handle != INVALID_HANDLE_VALUE) return descriptor_of(handle, opening == Opening::to_read);
  keep_windows_error();
  return {};
}

std::optional<FileFacts> facts_of(int descriptor) {
  const HANDLE handle = handle_of(descriptor);
  BY_HANDLE_FILE_INFORMATION facts{};
  const bool is_told = ::GetFileInformationByHandle(handle, &facts) != 0;
  const FileKind kind = kind_of(handle, is_told ? facts.dwFileAttributes : 0);
  if (kind != FileKind::regular) return FileFacts{kind, 0};
  if (!is_told) {
    keep_windows_error();
    return std::nullopt;
  }
  return FileFacts{kind, std::uint64_t{facts.nFileSizeHigh} << 32 | facts.nFileSizeLow};
}

bool is_there(const std::filesystem::path& path) {
  return ::GetFileAttributesW(path.c_str()) != INVALID_FILE_ATTRIBUTES;
}

bool is_same_file(int descriptor, const std::filesystem::path& path) {
  const Descriptor named = open_file(path, Opening::to_read);
  if (!named) return false;
  const auto wanted = number_of_file(handle_of(descriptor));
  return wanted && wanted == number_of_file(handle_of(named.get()));
}

std::ptrdiff_t read_some(int descriptor, std::span<std::byte> bytes) {
  DWORD count = 0;
  if (::ReadFile(handle_of(descriptor), bytes.data(), in_one_call(bytes.size()), &count, nullptr))
    return count;
  if (::GetLastError() == ERROR_BROKEN_PIPE) return 0;  // the end of a pipe
  keep_windows_error();
  return -1;
}

std::ptrdiff_t read_at(int descriptor, std::uint64_t position, std::span<std::byte> bytes) {
  OVERLAPPED place = place_at(position);
  DWORD count = 0;
  if (::ReadFile(handle_of(descriptor), bytes.data(), in_one_call(bytes.size()), &count, &place))
    return count;
  if (::GetLastError() == ERROR_HANDLE_EOF) return 0;
  keep_windows_error();
  return -1;
}

bool write_all(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    DWORD count = 0;
    const DWORD most = in_one_call(bytes.size());
    if (!::WriteFile(handle_of(descriptor), bytes.data(), most, &count, nullptr))
      return keep_windows_error();
    bytes = bytes.subspan(count);
  }
  return true;
}

bool write_all_at(int descriptor, std::uint64_t position, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    OVERLAPPED place = place_at(position);
    DWORD count = 0;
    const DWORD most = in_one_call(bytes.size());
    if (!::WriteFile(handle_of(descriptor), bytes.data(), most, &count, &place))
      return keep_windows_error();
    bytes = bytes.subspan(count);
    position += count;
  }
  return true;
}

bool resize_file(int descriptor, std::uint64_t size) {
  FILE_END_OF_FILE_INFO end{};
  end.EndOfFile.QuadPart = static_cast<LONGLONG>(size);
  if (::SetFileInformationByHandle(handle_of(descriptor), FileEndOfFileInfo, &end, sizeof end))
    return true;
  return keep_windows_error();
}

bool flush_contents(int descriptor) {
  return ::FlushFileBuffers(handle_of(descriptor)) ? true : keep_windows_error();
}

/// Since Windows 10 a file that others have open and share can be replaced. Older ones say "access
/// is denied" for every open file.
bool replace_name(const std::filesystem::path& from, const std::filesystem::path& to,
                  Descriptor held) {
  held.close();
  if (replace_open(from, to)) return true;
  if (move_name(from, to, MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH)) return true;
  const DWORD attributes = ::GetFileAttributesW(to.c_str());
  const bool may_be_written = (attributes & FILE_ATTRIBUTE_READONLY) == 0;
  if (errno == EACCES && attributes != INVALID_FILE_ATTRIBUTES && may_be_written) errno = EBUSY;
  return false;
}

bool take_name(const std::filesystem::path& from, const std::filesystem::path& to) {
  return move_name(from, to, MOVEFILE_WRITE_THROUGH);
}

void remove_name(const std::filesystem::path& path) { ::DeleteFileW(path.c_str()); }

}  // namespace pliant
