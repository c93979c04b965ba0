# SPDX-License-Identifier: MIT
"""What the page says of how its numbers were made."""

METHODS = (
    ("Flexibility", "RMSF of each residue's CA (or P; else of its atoms but hydrogens) about the "
     "average, after superposition on it. Errors come from independent blocks of frames: those of "
     "a hundred that pliant sample makes, else stretches of ten correlation lengths. Relative "
     "variances of few blocks are shrunk towards their mean over all residues (Smyth 2004), and "
     "widened by Student's t."),
    ("Converged", "The profiles of the two halves of the frames correlate by 0.95 or more and "
     "differ by 10 % or less."),
    ("Domains", "Residues are split in two where both parts move against each other at least 0.9 "
     "times as far as they deform themselves (r.m.s., after Hayward and Berendsen 1998), each part "
     "again, and so on: first by how little distances fluctuate (average linkage), then each "
     "residue goes with the part whose motion it follows. A part has 20 residues or more, and a "
     "split explains 4 % of all motion or more. This is done for 50 resamples of the frames "
     "(blocks drawn with replacement). A domain is what is together in 90 % of the resamples, and "
     "a part by itself in 80 %; two domains are apart in 90 %; what is neither is undecided. A "
     "hinge is where a chain goes from one domain to the next, with the share of resamples in "
     "which the residue is there."),
    ("Other shapes", "Frames drawn to reach further than those around the start, if their RMSD "
     "from it (CA or P, superposed) is above 3 Å and above that of every frame around it. They are "
     "put together (average linkage) while they are less apart than √2 of that limit, and further "
     "until there are eight shapes at most; single outliers are not listed. The frame "
     "shown is the medoid; the spread is the mean RMSD of the frames from it. What rotated are "
     "pieces that are rigid from the start to that frame (see Domains); angles are against the "
     "largest. A contact is gone when the frame lets it go, or exceeds it by more than 0.1 Å."),
    ("Known pairs", "How far apart two known structures of a protein are, for the 16 of 58 starts "
     "whose network is as soft (1 / lowest eigenvalue of Kirchhoff's matrix of alpha carbons): the "
     "quartiles. All are proteins that are known to move, so others may move less; of proteins "
     "left out, 57 % lay between the quartiles; but this softness was chosen among 17 measures on "
     "the same pairs. Of single chains only. It is a hint, no limit."),
    ("Pockets", "Room for a sphere of 1.4 Å that none of 4 Å from outside comes within 2.4 Å of, "
     "on a grid of 1 Å, between heavy atoms of protein and nucleic acids: of a closed cavity it "
     "finds 94 to 97 % of the volume. Ligands and water count as empty; a cleft open to water is "
     "no pocket. Listed is what has 100 Å³ more room beside its residues than at the start, and "
     "more than the mean and two standard deviations of five frames around it."),
    ("Pocket volumes", "Room for a sphere of 1.4 Å that touches no atom, within the convex hull of "
     "the heavy atoms that line the pocket, on a 1 Å grid, where it is enclosed: at least half of "
     "all directions meet an atom within 8 Å (Halgren 2009). The atoms are within 4.5 Å of a "
     "ligand, or nearest to a pocket of the start (or of a frame where one grows), the same in "
     "all frames. Ligands and water are taken out. The error is the r.m.s. difference from a grid "
     "of 0.5 Å. Where less than half as much of the room is enclosed as at the start, the lining "
     "has come apart: that frame has a gap, and no volume. A pocket opens if it grows by 100 Å³ "
     "from less than 100 Å³ at the start, hardly room for a benzene; it widens if it was open. Up "
     "to 100 frames are measured."),
    ("Collectivity", "exp of the entropy of the residues' shares, over their number (Brueschweiler "
     "1995): 1 if all move equally."),
    ("Stereochemistry", "Up to 100 frames, spread over all. Bond angles against the start "
     "structure; inverted carbons; centres with three neighbours off their plane; "
     "phi and psi of residues but glycine and proline in regions that hold 90 % (favoured) and "
     "99.5 % (allowed) of those of 500 crystal structures (Lovell 2003); heavy atoms more than "
     "three bonds apart that are nearer than the outer limits of Ramachandran and Sasisekharan "
     "(1968) and were not at the start."),
    ("Residuals", "|length − rest length| / rest length of every bar in every frame, from the "
     "coordinates as they are stored. A frame is within tolerance when all its bars are."),
    ("Superposition", "Frames are fitted by least squares (Kabsch) with equal weights."),
    ("RMSD", "Root mean square distance from the first frame analysed."),
    ("RMSF", "Root mean square distance from the average place, after superposition on the "
     "average structure, which is found by iteration. For a residue: root of the mean of its "
     "atoms' squares."),
    ("Torsions", "A bond is rotatable when it is in no ring and both ends have another neighbour. "
     "Mean and spread are circular; beyond 180° it means that all angles are equally likely."),
    ("PCA", "Eigenvectors of the covariance of the superposed coordinates. A cosine content near "
     "1 says that the motion along a component looks like a random walk: the run is too short to "
     "have visited its states repeatedly."),
    ("Frames", "All counts of frames and atoms begin at 0. A step of a geometric run is a push and "
     "its resolution, not a time."),
)  # fmt: skip  # a table: a row a line
