// SPDX-License-Identifier: MIT
// The calls of the page, by the sources that hold them. What each asks and replies: README.md.
#pragma once

#include "call.hpp"

namespace pliant::play {

// open_calls.cpp: choices, and documents.
Reply boot(const Request& request);
Reply open(const Request& request);
Reply example(const Request& request);

// step_calls.cpp, steps/select_call.cpp: the session.
Reply pull(const Request& request);
Reply resolution(const Request& request);
Reply wander(const Request& request);
Reply forces(const Request& request);
Reply again(const Request& request);
Reply undo(const Request& request);
Reply state(const Request& request);
Reply settings(const Request& request);
Reply step_limit(const Request& request);
/// Joints that `text` selects, in the language of `pliant run --select`.
Reply select_joints_of(const Request& request);

// edits/edit_calls.cpp, edits/why_call.cpp: what holds.
/// Makes edits [[word, a, b], ...]: "cut", "bar" (and a length, else the present distance),
/// "restore", and "turn": cuts all bars that keep a bond from turning. Replies as edited().
Reply edit(const Request& request);
/// The reply of `open` for what there is after all edits, and `changes` in words.
Reply edited(const Request& request);
/// What joins two joints, how far apart they are, and what may be done about it.
Reply pair(const Request& request);
/// Answers for a `joint` that is drawn to `target` by `share` of the way, at most `furthest`
/// Angstrom a step: `said`, one sentence or more, and `lines`, each with what holds, its joints and
/// whether it can be cut. Nothing changes.
Reply why(const Request& request);

// steps/replay_calls.cpp: force files.
/// What the header of a force file says, for a page that has to open the right model first.
Reply force_file(const Request& request);
/// Reads a force file for the session, which has made no step: its events as rows of a list.
Reply begin_replay(const Request& request);
/// Steps of it, at least one, for so many `milliseconds`, at most `most`.
Reply replay_steps(const Request& request);

// path_calls.cpp: a path from the open molecule to another structure of it.
/// Reads the other structure and begins a session at the start of the path.
Reply begin_path(const Request& request);
/// Continues it for some milliseconds, at least one step.
Reply path_steps(const Request& request);

// recorded_call.cpp: files.
/// What `pliant run --forces` would record for the session: `parameters` as rows of path, type and
/// value, and the texts and numbers of `topology` by name.
Reply recorded(const Request& request);

}  // namespace pliant::play
