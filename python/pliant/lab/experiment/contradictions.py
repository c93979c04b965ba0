# SPDX-License-Identifier: MIT
"""Where the thesis contradicts itself, so that no experiment can agree with all of it."""

#: place, what it says, what it says elsewhere
CONTRADICTIONS = (
    ("5.2.1 and 5.2.2", "bfs_cycle 0.5 and dfs_cycle 0.5 \"perform at or better than Ragdoll\"",
     "dfs_cycle 0.5: \"its average is still too high to be superior to Ragdoll\""),
    ("5.2.2", "bfs_reverse 0.5 \"outperforms the other techniques\"",
     "the next sentence: bfs_cycle 0.5 \"is currently the technique with the lowest mean\""),
    ("5.2.2 and 5.3.1", "the reverse techniques perform \"very similarly\" to the cycle ones; the "
     "new best is \"albeit nominally\" so", "they \"showed a large improvement\""),
    ("5.2.1 and 5.2.2", "bfs_cycle has mode 1 at every weighting",
     "bfs_reverse \"has dropped to a mode of 2\" at 0.5 and 0.75"),
    ("5.2.2", "bfs_reverse has mode 2 at two of three weightings",
     "bfs_reverse \"still most commonly solves the constraints in 1 iteration\""),
    ("figure 5.5", "BFS_reverse: the turning bar is printed once",
     "DFS_reverse: twice; and whether one iteration is one direction or both is not said"),
    ("figure 5.7", "the caption says 1-cycle", "the list of figures and the text say 2-cycle"),
    ("4.1.1 and 5", "the ordering stands in a file, one for each graph",
     "the ordering begins at the joint that the force affects, which each force chooses anew"),
    ("3.2.3", "a 2-cycle graph \"contains exactly two cycles\"",
     "its third type, a path between two joints of a cycle, contains three"),
    ("3.2.1 and 3.2.2", "a tree has n = m + 1; figure 3.6 adds a bar and lists seven",
     "and counts |E| = 6"),
    ("5.2.2 and 6", "bfs_reverse 1.0 \"performs much worse than the other techniques\"",
     "\"BFS_reverse consistently outperforms other constraint satisfaction techniques\""),
)  # fmt: skip  # a table: a row a line
