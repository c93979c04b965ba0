// SPDX-License-Identifier: MIT
#include "pliant/record/h5md/h5md_recorder.hpp"

#include "pliant/base/error.hpp"
#include "pliant/record/h5md/h5md_writer.hpp"

namespace pliant {
namespace {

const H5mdOptions& checked_options(const H5mdOptions& options) {
  if (!(options.flush_seconds >= 0.0))
    throw OptionError("H5mdOptions::flush_seconds = " + std::to_string(options.flush_seconds) +
                      ": must be 0 or more");
  if (!(options.precision >= 0.0 && options.precision <= 1.0))
    throw OptionError("H5mdOptions::precision = " + std::to_string(options.precision) +
                      ": must be from 0 to 1 Angstrom");
  return options;
}

}  // namespace

H5mdRecorder::H5mdRecorder(const std::filesystem::path& path, const Framework& framework,
                           const H5mdHeader& header, const H5mdOptions& options)
    : writer_(std::make_unique<H5mdWriter>(path, framework, header, checked_options(options))) {}
H5mdRecorder::H5mdRecorder(const H5mdCheckpoint& from, const H5mdOptions& options)
    : writer_(std::make_unique<H5mdWriter>(from, checked_options(options))) {}
H5mdRecorder::~H5mdRecorder() = default;
H5mdRecorder::H5mdRecorder(H5mdRecorder&&) noexcept = default;
H5mdRecorder& H5mdRecorder::operator=(H5mdRecorder&&) noexcept = default;

void H5mdRecorder::record(const Frame& frame) { writer_->record(frame); }
void H5mdRecorder::end_run(const State& state) { writer_->end_run(state); }
void H5mdRecorder::flush() { writer_->flush(); }
void H5mdRecorder::close() { writer_->close(); }
std::int64_t H5mdRecorder::frames() const { return writer_->frames(); }
std::int64_t H5mdRecorder::committed_frames() const { return writer_->committed_frames(); }
const std::filesystem::path& H5mdRecorder::path() const { return writer_->path(); }

}  // namespace pliant
