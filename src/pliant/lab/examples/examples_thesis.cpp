// SPDX-License-Identifier: MIT
#include "pliant/lab/examples/example_rows.hpp"

namespace pliant {

// The thesis gives graphs, not places: the places are ours, and so is the order of the bars where
// the printed orderings leave it open.
std::vector<ExampleRow> thesis_examples() {
  return {
      {"thesis_figure_2_2",
       "thesis, figure 2.2: cycle graph C5",
       spelled("ab ac bd ce de", {{0, 2, 0}, {-2, 1, 0}, {2, 1, 0}, {-1, -1, 1}, {1, -1, 0}}),
       {.cycles = 1, .blocks = 1, .rank = 5, .rigid_motions = 6, .flexes = 4}},
      {"thesis_figure_5_2",
       "thesis, figure 5.2: 2-cycle",
       spelled("ab ac af bd ce fg de eg",
               {{0, 3, 0}, {-3, 2, 1}, {0, 1, 0}, {-3, -1, 0}, {0, -2, 1}, {3, 2, 0}, {3, -1, 1}}),
       {.cycles = 2, .blocks = 1, .rank = 8, .rigid_motions = 6, .flexes = 7}},
      {"thesis_figure_5_5",
       "thesis, figures 5.5 and 5.8: 1-cycle",
       spelled("ab ac bd cb", {{0, 2, 0}, {-1, 0, 0}, {1, 0, 1}, {-2, -2, 0}}),
       {.cycles = 1, .bridges = 1, .blocks = 1, .rank = 4, .rigid_motions = 6, .flexes = 2}},
      {"thesis_figure_5_10",
       "thesis, figure 5.10: 2-cycle",
       spelled("ab ac bd cb df cd fe",
               {{0, 3, 0}, {-2, 1, 0}, {2, 1, 1}, {0, -1, 0}, {2, -4, 1}, {0, -3, 0}}),
       {.cycles = 2, .bridges = 2, .blocks = 1, .rank = 7, .rigid_motions = 6, .flexes = 5}},
      {"thesis_figure_3_5",
       "thesis, figure 3.5: tree T",
       spelled("ac bc cd ce ef eg",
               {{-2, 2, 0}, {0, 3, 1}, {0, 0, 0}, {2, 1, 0}, {-1, -2, 1}, {-3, -3, 0}, {1, -3, 0}}),
       {.bridges = 6, .rank = 6, .rigid_motions = 6, .flexes = 9}},
      {"thesis_figure_3_6",
       "thesis, figure 3.6: 1-cycle S",
       spelled("ac bc cd ce ef eg fg",
               {{-2, 2, 0}, {0, 3, 1}, {0, 0, 0}, {2, 1, 0}, {-1, -2, 1}, {-3, -3, 0}, {1, -3, 0}}),
       {.cycles = 1, .bridges = 4, .blocks = 1, .rank = 7, .rigid_motions = 6, .flexes = 8}},
      {"thesis_figure_3_7",
       "thesis, figure 3.7: 2-cycle D",
       spelled("ac bc cd ce ef eg fg dg",
               {{-2, 2, 0}, {0, 3, 1}, {0, 0, 0}, {2, 1, 0}, {-1, -2, 1}, {-3, -3, 0}, {1, -3, 0}}),
       {.cycles = 2, .bridges = 2, .blocks = 1, .rank = 8, .rigid_motions = 6, .flexes = 7}},
  };
}

}  // namespace pliant
