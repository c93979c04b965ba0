// SPDX-License-Identifier: MIT
#include "pliant/stream/imd_session.hpp"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "pliant/base/error.hpp"

namespace pliant {

ImdSession::ImdSession(Peer peer, const ImdFormat& format, std::size_t joint_count,
                       ImdExchange& exchange, const ImdPatience& patience, const Descriptor* others)
    : peer_(std::move(peer)),
      format_(format),
      exchange_(exchange),
      patience_(patience),
      others_(others),
      reader_(format, joint_count),
      greeting_(imd_greeting(format)) {}

ImdSession::~ImdSession() { exchange_.end_client(); }

bool ImdSession::step() {
  if (exchange_.is_finishing() && phase_ < Phase::flushing) {
    if (phase_ == Phase::greeting) return false;
    begin_finish();
  }
  fill();
  const bool has_more = sent_ < out_->size();
  const auto events = static_cast<short>(has_more ? POLLIN | POLLOUT : POLLIN);
  const int others = gives_way() ? others_->get() : -1;  // which poll() passes over
  std::array<pollfd, 3> waits{
      {{exchange_.woken().get(), POLLIN, 0}, {peer_.socket.get(), events, 0}, {others, POLLIN, 0}}};
  if (poll(waits.data(), waits.size(), milliseconds_left()) < 0 && errno != EINTR) return false;
  if (waits[0].revents != 0) sleep_again(exchange_.woken());
  if ((waits[1].revents & (POLLIN | POLLHUP | POLLERR)) != 0 && !receive()) return false;
  if ((waits[1].revents & POLLOUT) != 0 && !send()) return false;
  if (waits[2].revents != 0 && gives_way())
    throw InputError("did not say GO in time, and another client waits");
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
  if (sent_ < out_->size() || phase_ == Phase::greeting || phase_ == Phase::draining) return;
  out_ = &frame_;
  sent_ = 0;
  if (exchange_.next_frame(frame_) || phase_ != Phase::flushing) return;
  shutdown(peer_.socket.get(), SHUT_WR);
  phase_ = Phase::draining;
  since_ = Clock::now();
}

ImdSession::Clock::time_point ImdSession::deadline() const {
  if (phase_ == Phase::greeting) return since_ + patience_.go_alone;
  if (phase_ >= Phase::flushing) return since_ + patience_.finish;
  return reader_.is_within_packet() ? since_ + patience_.packet : Clock::time_point::max();
}

bool ImdSession::gives_way() const {
  return phase_ == Phase::greeting && others_ != nullptr && Clock::now() >= since_ + patience_.go;
}

int ImdSession::milliseconds_left() const {
  auto end = deadline();
  if (phase_ == Phase::greeting && !gives_way()) end = std::min(end, since_ + patience_.go);
  if (end == Clock::time_point::max()) return -1;
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
  return static_cast<int>(std::max<std::int64_t>(left, 0));
}

/// False at the end of a session that may end so.
bool ImdSession::expire() const {
  if (phase_ == Phase::greeting) throw InputError("did not say GO in time");
  if (phase_ == Phase::following) throw InputError("stopped in the middle of a packet");
  return false;
}

bool ImdSession::receive() {
  std::array<std::byte, 65536> bytes{};
  const ssize_t count = recv(peer_.socket.get(), bytes.data(), bytes.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  if (count == 0) return false;
  if (phase_ >= Phase::flushing) return true;
  if (phase_ == Phase::following) since_ = Clock::now();
  reader_.take({bytes.data(), static_cast<std::size_t>(count)});
  return obey();
}

bool ImdSession::send() {
  const ssize_t count =
      ::send(peer_.socket.get(), out_->data() + sent_, out_->size() - sent_, MSG_NOSIGNAL);
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  sent_ += static_cast<std::size_t>(count);
  if (phase_ == Phase::flushing) since_ = Clock::now();
  if (out_ == &frame_ && sent_ == frame_.size()) {
    exchange_.take_back(std::exchange(frame_, {}));
    sent_ = 0;
  }
  return true;
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
  exchange_.begin_client();
}

bool ImdSession::obey(const ImdCommand& command) {
  switch (command.type) {
    case ImdType::disconnect:
      return false;
    case ImdType::kill:
      exchange_.kill();
      break;
    case ImdType::forces:
      exchange_.pull(command.forces);
      break;
    case ImdType::rate:
      exchange_.set_rate(command.value);
      break;
    case ImdType::resume:
      exchange_.pause(false);
      break;
    case ImdType::wait:
      exchange_.set_waits(command.value != 0);
      break;
    case ImdType::pause:
      // A second one goes on again in version 2, which has no other way.
      format_.version >= 3 ? exchange_.pause(true) : exchange_.toggle_pause();
      break;
    default:
      throw InputError("said GO twice");
  }
  return true;
}

}  // namespace pliant
