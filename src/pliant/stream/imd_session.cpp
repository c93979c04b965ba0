// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_session.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "pliant/base/error.hpp"
#include "pliant/base/number.hpp"

namespace pliant {
namespace {

/// Both parts of what goes out, without the bytes that have gone.
std::array<Part, 2> left_of(const ImdOutgoing& out, std::size_t sent) {
  std::array<Part, 2> parts{};
  std::size_t part = 0;
  for (const Bytes* bytes : {&out.head, static_cast<const Bytes*>(out.body.get())}) {
    if (bytes == nullptr) continue;
    const std::size_t gone = std::min(sent, bytes->size());
    parts[part++] = Part(*bytes).subspan(gone);
    sent -= gone;
  }
  return parts;
}

std::string seconds_text(std::chrono::milliseconds time) {
  return number_text(static_cast<double>(time.count()) / 1000.0) + " s";
}

}  // namespace

ImdSession::ImdSession(Peer peer, const ImdFormat& format, std::size_t joint_count,
                       ImdExchange& exchange, const ImdPatience& patience)
    : peer_(std::move(peer)),
      format_(format),
      exchange_(exchange),
      patience_(patience),
      reader_(format, joint_count),
      out_{imd_greeting(format)} {}

ImdSession::~ImdSession() {
  if (follower_ != nullptr) exchange_.end_client(*follower_);
}

SocketEvents ImdSession::events() {
  fill();
  // A client that has all there was for it is asked whether more would go out at once.
  const bool is_asked = phase_ == Phase::following && !is_ready_;
  return {peer_.socket.get(), true, has_more() || is_asked};
}

bool ImdSession::step(const SocketEvents& found) {
  if (exchange_.is_finishing() && phase_ < Phase::flushing) {
    if (phase_ == Phase::greeting) return false;
    begin_finish();
  }
  if (found.can_read && !receive()) return false;
  if (found.can_write && !send()) return false;
  return !is_late() || expire();
}

/// What has been said until now is still sent; what the client says is read and forgotten: bytes
/// left unread when a socket closes would take from the client what it has not read yet.
void ImdSession::begin_finish() {
  phase_ = Phase::flushing;
  since_ = Clock::now();
}

/// Goes on to the next frame once the last one is sent.
void ImdSession::fill() {
  if (has_more() || phase_ == Phase::greeting || phase_ == Phase::draining) return;
  if (exchange_.next_frame(*follower_, out_)) {
    is_ready_ = false;
    took_ = Clock::now();
  } else if (phase_ == Phase::flushing) {
    end_sending(peer_.socket);
    phase_ = Phase::draining;
    since_ = Clock::now();
  }
}

ImdSession::Clock::time_point ImdSession::packet_deadline() const {
  return reader_.is_within_packet() ? since_ + patience_.packet : Clock::time_point::max();
}

/// A client that holds the run need not read what was sent before.
ImdSession::Clock::time_point ImdSession::reading_deadline() const {
  const bool is_behind = has_more() || !is_ready_;
  return is_behind && !is_paused_ ? took_ + patience_.reading : Clock::time_point::max();
}

ImdSession::Clock::time_point ImdSession::deadline() const {
  if (phase_ == Phase::greeting) return since_ + patience_.go;
  if (phase_ >= Phase::flushing) return since_ + patience_.finish;
  return std::min(packet_deadline(), reading_deadline());
}

/// False at the end of a session that may end so.
bool ImdSession::expire() const {
  if (phase_ == Phase::greeting) throw InputError("did not say GO in time");
  if (phase_ != Phase::following) return false;
  if (reading_deadline() <= packet_deadline())
    throw InputError("read nothing for " + seconds_text(patience_.reading));
  throw InputError("stopped in the middle of a packet");
}

bool ImdSession::receive() {
  std::array<std::byte, 65536> bytes{};
  const Transfer came = pliant::receive(peer_.socket, bytes);
  if (came.count == 0) return came.is_open;
  if (phase_ >= Phase::flushing) return true;
  if (phase_ == Phase::following) since_ = Clock::now();
  reader_.take({bytes.data(), came.count});
  return obey();
}

bool ImdSession::send() {
  if (!has_more()) {
    is_ready_ = phase_ == Phase::following;
    if (is_ready_) exchange_.set_ready(*follower_);
    return true;
  }
  const Transfer gone = send_parts(peer_.socket, left_of(out_, sent_));
  if (gone.count == 0) return gone.is_open;
  sent_ += gone.count;
  took_ = Clock::now();
  if (phase_ == Phase::flushing) since_ = took_;
  if (!has_more()) end_frame();
  return true;
}

void ImdSession::end_frame() {
  sent_ = 0;
  ImdOutgoing sent = std::exchange(out_, {});
  if (sent.body) exchange_.take_back(std::move(sent));
}

bool ImdSession::obey() {
  while (const std::optional<ImdCommand> command = reader_.next()) {
    if (phase_ == Phase::greeting) {
      begin(*command);
    } else if (!obey(*command)) {
      return false;
    }
  }
  return true;
}

void ImdSession::begin(const ImdCommand& command) {
  if (command.type != ImdType::go) throw InputError("said something before GO");
  phase_ = Phase::following;
  follower_ = &exchange_.begin_client();
  took_ = Clock::now();
}

void ImdSession::pause(bool is_paused) {
  is_paused_ = is_paused;
  took_ = Clock::now();
  exchange_.pause(*follower_, is_paused);
}

bool ImdSession::obey(const ImdCommand& command) {
  switch (command.type) {
    case ImdType::disconnect:
      return false;
    case ImdType::kill:
      exchange_.kill(peer_.name);
      break;
    case ImdType::forces:
      exchange_.pull(*follower_, command.forces);
      break;
    case ImdType::rate:
      exchange_.set_rate(*follower_, command.value);
      break;
    case ImdType::resume:
      pause(false);
      break;
    case ImdType::wait:
      exchange_.set_waits(command.value != 0);
      break;
    case ImdType::pause:
      // A second one goes on again in version 2, which has no other way.
      pause(format_.version >= 3 || !is_paused_);
      break;
    default:
      throw InputError("said GO twice");
  }
  return true;
}

}  // namespace pliant
