/// @file
/// Every number that was chosen by measurement, with what it was measured on. `./run bench tuning` measures
/// them anew. None of them changes a result.
///
/// "EPYC" below is two cores of an AMD EPYC with AVX2, GCC 12, release build; scenes and suites are those of
/// bench/.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cellsweep::tuning {

// --- threads -----------------------------------------------------------------------------------------------

/// More threads than this were never measured; left to itself, `stream` takes no more.
inline constexpr unsigned kMostWorkers = 16;
/// Not even when asked for does a worker get less to do than this.
inline constexpr std::size_t kLeastItems = 16;
/// Work worth less than this on one thread, in seconds, is not worth asking what a dispatch takes. EPYC,
/// threads/.
inline constexpr double kTooSmall = 100e-6;
/// What so many items take is looked at all the same: it may be more than it was. 0.3 % of what takes a
/// nanosecond each. Chosen, not measured.
inline constexpr std::size_t kLeastTimed = 16'384;
/// What starting threads takes, roughly, until they have done their first job. EPYC, threads/.
inline constexpr double kStartCost = 300e-6;
/// A frame has about so many jobs for the workers.
inline constexpr double kJobs = 8;
/// What a dispatch takes is measured with tasks that take so many seconds: a thread that has not begun its
/// own by then is too late. EPYC, threads/.
inline constexpr double kTrialTask = 10e-6;
/// Dispatches of which the quickest counts.
inline constexpr int kDispatches = 3;
/// So many times that is too much for what workers would save, and it is measured again. How often a machine
/// has bad moments no measurement tells: to measure again takes four dispatches, little beside what so many
/// jobs take that went without workers, and they may have them again within the second.
inline constexpr std::uint64_t kPatience = 32;
/// Work that is done by all workers, or by one alone, is done the other way so often in a row after so many
/// times; after twice as many, and so many at most, where the other way was the slower one. Chosen, not
/// measured.
inline constexpr std::uint32_t kTurnsOfTrial = 3;
inline constexpr std::uint32_t kLeastTurns = 2;
inline constexpr std::uint32_t kMostTurns = 1024;
/// Where one way takes so many times as long as the other, two turns are enough to know it, and it is not
/// tried again for so many. EPYC, 100,000 all new, 40 times, and a tenth moving, 24 times.
inline constexpr double kClearGain = 1.25;
inline constexpr std::uint32_t kLeastTurnsOfClear = 16;
/// What takes so many times as long was delayed by chance, unless it is so once more. Chosen, not measured.
inline constexpr double kIncredible = 4;
/// The least that work took is taken for so many times as much with each turn that took more. Chosen, not
/// measured.
inline constexpr double kBestForgets = 1.1;
/// All workers are used when they take less than this share of the time of one: what they take besides is
/// the others'. Chosen, not measured.
inline constexpr double kLeastGain = 0.95;

// --- seconds of one body or pair on one thread: first guesses, which every update corrects
// --------------------

inline constexpr double kInsertGuess = 4e-9;     ///< to check and remember a new body. EPYC, uniform 100,000
inline constexpr double kMoveGuess = 4e-9;       ///< to check and remember a move. EPYC, uniform 100,000
inline constexpr double kFullGuess = 50e-9;      ///< to find everything anew. EPYC, uniform 10,000, initial
inline constexpr double kPartialGuess = 200e-9;  ///< to look at one changed fat box. EPYC, uniform 10,000
inline constexpr double kTestGuess = 4e-9;       ///< to test a candidate. EPYC, uniform 100,000, all moving

/// The share of changed fat boxes at which everything is found anew lies between these, whatever was
/// measured. EPYC, all scenes, 1 to 100 % moving.
inline constexpr double kLeastShare = 0.1;
inline constexpr double kMostShare = 0.5;

// --- fat boxes
// ------------------------------------------------------------------------------------------------

/// Updates that a fat box is made for when all are made anew. Bodies that keep their course leave them all at
/// once, which is when starting anew pays. EPYC, all scenes, all moving.
inline constexpr std::uint32_t kAllAhead = 8;
/// And when one is, by chance between these: a share of them is left each time. EPYC, uniform, varied, wall
/// and clustered 10,000, with 4 to 12 and a growth of half a length: a tenth moving takes 1.1 to 1.2 times as
/// long, all moving as long in the mean and 1.05 to 1.4 times in the 99th percentile. With 12 to 24 there are
/// waves of them where a tenth begins to move at once: a 99th percentile 1.1 times as long.
inline constexpr std::uint32_t kOneAhead = 32;
inline constexpr std::uint32_t kOneAheadAtLeast = 8;
/// In a world without cells all are made anew when the first one is left and most will be within so many
/// updates. EPYC, swarm 1,000, all moving: 0.76 of the time, and other scenes as before.
inline constexpr float kLeftSoon = 2;
/// How much of its own length a box may grow on an axis.
inline constexpr float kMostGrowth = 1;
/// And how much it grows at least when it moves. EPYC, stacks in Bullet, which sink a little in each step.
inline constexpr float kLeastGrowth = 1.0F / 64;
/// Updates that one of a body that trembles is made for, with as much to either side.
inline constexpr std::uint32_t kTrembleAhead = 12;
/// And it grows so much there at most; what moves further at a time is on its way. EPYC, cubes that go to
/// and fro: a step below it leaves no fat box, one above it every time.
inline constexpr float kMostTremble = 0.125F;
/// A body that leaves its fat box after no more updates than this has turned back. EPYC, cubes that go to and
/// fro in small steps: up to four each way leave no fat box.
inline constexpr unsigned kEarly = 3;
/// Of one that is known to tremble, whose fat boxes are made for the most updates. EPYC, stacks in Bullet.
inline constexpr unsigned kEarlyOfTrembling = 8;
/// One that left its fat box later, in about as many updates as its last step takes to go so much of the room
/// in there or all of it, was on its way, and had but turned. EPYC, uniform 10,000, all moving: without this
/// ever more were taken to tremble, and after 300 updates 1,200 instead of 600 left theirs in eight of them.
/// Chosen: a slow body has as much room to either side as on its way.
inline constexpr float kRoomOnCourse = 0.45F;
/// A fat box of one reaches so many times its step to either side at first, a length kMostTremble halved so
/// often at least, kLeastGrowth; where it did not last, so many halvings less. EPYC, stacks in Bullet: half
/// as many leave theirs as with 15, at 4.
inline constexpr int kMostHalvings = 3;
inline constexpr float kStepsOfTrembling = 4;
inline constexpr int kRaise = 2;
/// Where there is no more than one candidate that is no pair for so many pairs, fat boxes reach so much at
/// least, and to either side kMostTremble halved so often. EPYC, stacks in Bullet of 1,000 and 5,000: 3 in
/// 1,000 leave theirs in an update instead of 20; with an eighth it takes the same.
inline constexpr std::size_t kPairsOfSpareCandidate = 8;
inline constexpr float kAmpleGrowth = 1.0F / 16;
inline constexpr int kAmpleHalvings = 1;
/// And where there are more than so many candidates for each pair, and one for two bodies, hardly further
/// than bodies tremble. EPYC: piles in Bullet have two for each pair, and take 1.1 times as long then.
/// Columns that tremble by a hundredth, a thousandth and a ten-thousandth of their width: with 4 steps, or 2
/// halvings less, those that stand close have up to five times the candidates; with 1 step fat boxes do not
/// last.
inline constexpr std::size_t kUsualCandidates = 3;
inline constexpr int kTightHalvings = 9;
inline constexpr float kTightSteps = 2;
inline constexpr int kTightRaise = 1;
/// What had to be taken back is not done for so many updates, and twice as many each time, up to so many.
/// Chosen, not measured.
inline constexpr std::uint32_t kPatienceOfGrowth = 64;
inline constexpr std::uint32_t kMostPatienceOfGrowth = 16'384;

/// To make all fat boxes anew takes as long as so many looks at a candidate for each body, and so many for
/// each candidate. EPYC, piles in Bullet, 5,000 and 20,000.
inline constexpr std::uint64_t kLooksOfFull = 25;
inline constexpr std::uint64_t kLooksOfCandidate = 5;
/// One that is put into cells singly takes as long as so many: kPartialGuess and kTestGuess.
inline constexpr std::uint64_t kLooksOfPlaced = 50;
/// They are once candidates that are no pairs have cost so many times that, up to so many times more where it
/// was of no use, which shows so many updates later. Chosen, not measured.
inline constexpr std::uint64_t kPricesOfRefit = 2;
inline constexpr std::uint64_t kMostPatienceOfRefit = 32;
inline constexpr std::uint32_t kUpdatesToRefit = 16;

// --- finding everything anew a part at a time
// --------------------------------------------------------------------------

/// At least so many updates have a part of it each, and at most kAllAhead; with up to 14 it takes the same.
/// EPYC, uniform and varied, 1,000 to 100,000, all moving.
inline constexpr std::uint32_t kLastsAtLeast = 4;
/// Where bodies creep and their fat boxes last for longer, at most so many: chosen, not measured.
inline constexpr std::uint32_t kMostForNext = 2 * kAllAhead;
/// Where it is done in so many parts, none is more than so many times as long as in the mean; where it is
/// done in fewer, all are as long. Chosen, not measured.
inline constexpr std::uint32_t kFewParts = 5;
inline constexpr double kMostOfPart = 4.0 / 3;
/// To either side a fat box that is used later reaches so many of its box's lengths more: where a body will
/// be is told by a difference of two numbers, which is not exact. EPYC, uniform 100,000.
inline constexpr float kSlackOfLater = 1.0F / 256;
/// Where more than one in so many bodies has left its fat box by then, the next ones are made for less, where
/// fewer than one in so many, for more updates. A body that turns leaves two. Xeon, uniform, wall and varied
/// 10,000, all moving: with 8 the same mean and a 99th percentile 1.0 to 1.1 times as long, with 16 a mean of
/// 0.97 to 1.1.
inline constexpr std::size_t kManyEscaped = 10;
inline constexpr std::size_t kFewEscaped = 32;
/// Before they are made for more updates again, few must have left theirs so many times in a row at most; the
/// number doubles each time that this was too many updates.
inline constexpr std::uint32_t kMostPatience = 64;

// --- cells
// ----------------------------------------------------------------------------------------------------

/// Nanoseconds, roughly: to put one copy of a box into a cell, and to compare it with one other. EPYC, AVX2,
/// uniform and clustered, 1,000 to 1,000,000.
inline constexpr double kCopyCost = 14;
inline constexpr double kTestCost = 0.11;
/// Boxes of the sample on which a grid is chosen.
inline constexpr std::size_t kSample = 128;
/// Boxes of the sample that tell the middle edge. EPYC, varied 100,000.
inline constexpr std::size_t kEdgeSample = 32;
/// A box is large when an edge is so many times as long as that of the middle box of the sample. Shorter
/// ones, which only the sample knows of, reach into some 200 cells; so rare that it has none of them they are
/// cheap. EPYC, uniform 10,000, one in 200 a wall: the same to both sides of the limit.
inline constexpr float kLargeEdges = 12;
/// Where the sample has a large box, so many boxes tell how many there are, in runs of so many, when they
/// have so many large ones; else all boxes do. EPYC, varied 10,000 and 100,000: 3 ns a box less.
inline constexpr std::size_t kLargeSample = 1024;
inline constexpr std::size_t kRunOfSample = 16;
inline constexpr double kManyLarge = 16;
/// When boxes reach into more cells than so many times what a few of them made expect, a grid is chosen
/// again, after a look at all: that takes 7 ns a box. EPYC, varied and uniform, 100,000.
inline constexpr double kManyCopies = 1.5;
/// Boxes reach into no more cells than this, in the mean, whatever they are: memory is linear in bodies. What
/// would take more cells has more comparisons instead. EPYC, 200,000 rods in three directions: 2.2 s without
/// a limit (113 cells a rod).
inline constexpr double kMostCopies = 32;
/// Cells within cells, whose boxes have come into as many, may still have so many times as many.
inline constexpr double kMoreCopies = 1.0625;
/// So many boxes that a grid does not cut, or leaves in one cell, are looked at once more, all of them: to
/// compare them takes longer.
inline constexpr std::size_t kDoubted = 1024;
/// More cells than this are made in two steps: writing to more places at a time than a cache has lines is
/// slow, but so is to copy all boxes twice. EPYC, uniform, clustered, level and dust, one thread and two:
/// with 4,096 100,000 bodies took 1.1 to 1.5 times as long, 200,000 and 300,000 1.05 to 1.25 times; with
/// 32,768 500,000 take as long, and with 65,536 1,000,000 0.9 by one thread, 1.0 to 1.6 by two.
inline constexpr double kMaxCells = 16384;
/// Boxes of a cell that will be cut again. EPYC, the same scenes, 600,000 to 2,000,000: with 1,200 1.05
/// to 1.15 times as long, with 300 1.2 to 1.3 times, with 10,000 as long.
inline constexpr double kPieceBoxes = 8000;
/// The place of a copy is asked for so many copies before it is put there. EPYC, uniform, clustered and dust:
/// all new bodies take 0.81 to 0.94 of the time at 100,000, 0.92 at 10,000 that are not in the caches and
/// 1.01 where they are; with 20 and 80 as much, with 8 1.05 times.
inline constexpr std::size_t kCopiesAhead = 40;
/// A cell that changes come into is asked for so many such cells before. EPYC, uniform 100,000, a tenth
/// moving: to change cells takes 0.75 of the time, with half as many as much.
inline constexpr std::size_t kCellsAhead = 4;
/// A cell with more boxes is cut again when that pays. EPYC, clustered 100,000.
inline constexpr std::uint32_t kLargestCell = 160;
/// Boxes that no cut tells apart are compared all with all from here on.
inline constexpr unsigned kDeepest = 24;
/// What takes as long as to make cells anew, in comparisons for each box. EPYC, uniform 10,000 and 100,000.
/// When changes of cells come to more, or to this many and more copies than wear them out, cells are made
/// anew.
inline constexpr std::uint64_t kTestsOfBuild = 512;
inline constexpr std::uint64_t kFewTests = 1'000'000;
inline constexpr std::uint64_t kFewCopies = 4096;
/// A cell has room for one box more for so many that it has. Chosen, not measured.
inline constexpr std::size_t kBoxesOfSpare = 16;
/// More memory than this for each box is given back, in bytes.
inline constexpr std::size_t kBytesOfBox = 512;
/// Working memory grows by one part in so many. Chosen, not measured.
inline constexpr std::size_t kPartsOfStep = 16;

// --- the sweep of small worlds
// ------------------------------------------------------------------------------------------------

/// So many slots and fewer are swept when all are new. EPYC, AVX-512, all scenes: two and three times as many
/// would take 0.7 to 0.9 of the time that cells take, but few movers need these in the next update.
inline constexpr std::size_t kMostSwept = 2048;
/// And so many in every update, where fat boxes do not last. EPYC, AVX-512, piles while they fall and settle:
/// 0.7 to 0.8 of the time that cells would take at 1,000 and 2,000, 1.0 at 3,000.
inline constexpr std::size_t kMostSweptInMotion = 3072;
/// And so many while most bodies are on their way, whose updates ask for no memory then, and all take as
/// long. EPYC, AVX-512, uniform, varied, clustered and wall, all moving: fat boxes take 0.8 to 0.9 of the
/// mean time at 300 bodies, 0.65 to 0.8 at 1,000 to 3,000.
inline constexpr std::size_t kMostSweptFirst = 640;
/// A box of middle size reaches over so many numbers on the axis of the order. EPYC, AVX-512, 1,000 bodies in
/// all scenes.
inline constexpr double kPlacesOfEdge = 16;
/// Places are no more than so many times as many as boxes, up to twice that: to count takes time, too. EPYC,
/// AVX-512, axis, dust, uniform and clustered, 1,000 and 2,000: 0.93 to 1.03 of the time with half or twice
/// as many.
inline constexpr std::size_t kPlacesOfBox = 2;
/// More boxes than kMostSweptInMotion are not sorted where a few of them say that a box takes more
/// comparisons than this, each with as many others as a kernel compares at once. EPYC, AVX-512 and AVX2, all
/// scenes, 3,000 to 100,000: cells take as long from three to five on.
inline constexpr double kVectorsExpected = 3;
/// Cells take less than more such comparisons a body. EPYC, AVX-512, 1,024 cubes, ever more crowded: as much
/// from five or six on.
inline constexpr std::uint32_t kVectorsOfSwept = 6;
/// And than so many tests of boxes a body that find nothing. EPYC, AVX-512, uniform 1,024, some bodies
/// outside: as much from about four on.
inline constexpr std::uint32_t kTestsOfSwept = 8;
/// What a sweep learnt of where boxes are is good for so many more. EPYC, AVX-512, 1,000 bodies, all moving.
inline constexpr std::uint32_t kSweepsOfSample = 16;

// --- with fat boxes, or without
// ------------------------------------------------------------------------------------------------

/// So many bodies are watched for so many updates to tell whether they tremble. Chosen, not measured.
inline constexpr std::size_t kWatched = 32;
inline constexpr std::uint32_t kUpdatesWatched = 8;
/// One that did not stray further in that time, in its own lengths, is as good as at rest.
inline constexpr float kHardlyMoved = 1.0F / 256;
/// Bodies that creep, by no more than such a part of their length in an update, are as those that tremble:
/// where a tenth turns in each update, 700 to 5,000 take 0.25 to 0.6 of the time. With a 256th those take up
/// to twice as long that make a long step now and then.
inline constexpr float kCreepingStep = 1.0F / 1024;
/// Fat boxes have so many updates to start, those of bodies that tremble so many at most to settle; then they
/// are judged by so many at a time; by fewer where they take so many sweeps more, or updates without them in
/// a large world, which comes back to them sooner. EPYC, stacks of 1,000 and 2,000 in Bullet: where those
/// that tremble had no more than others they did not last, were tried again every 16 updates, and it all took
/// more than twice as long. A pile of 1,000 that begins to fall: with two to start 1.06 times as long.
inline constexpr std::uint32_t kUpdatesOfStart = 1;
inline constexpr std::uint32_t kUpdatesOfSettling = 8;
inline constexpr std::uint32_t kUpdatesJudged = 8;
inline constexpr std::int64_t kMostExcess = 4;
inline constexpr std::int64_t kMostExcessOfLarge = 2;
/// The most verdicts in a row that it takes to try them again, or to forget that they once did not last.
inline constexpr std::uint32_t kMostPatienceOfSweeps = 8;
/// Where a sweep would have taken more than cells, there is none for so many updates.
inline constexpr std::uint32_t kPauseOfSweeps = 64;
/// Nanoseconds, roughly, of an update with fat boxes: of each body, of one whose fat box is put into cells,
/// of one when all are, and of a candidate. EPYC, AVX-512, 1,000 bodies, all moving, and piles in Bullet.
inline constexpr std::uint64_t kFatBoxCost = 6;
inline constexpr std::uint64_t kPlacedCost = 220;
inline constexpr std::uint64_t kAllPlacedCost = 60;
inline constexpr std::uint64_t kCandidateCost = 4;
/// In a world that would be swept: of one that is put into cells, of a box that it is compared with there,
/// and of a candidate that it has. EPYC, AVX-512, piles of 1,000 to 3,000 in Bullet, where it has 80 to 350
/// comparisons and 7 to 16 candidates, 30 and 2 elsewhere: with 220 for all of it 1.05 times as long.
inline constexpr std::uint64_t kPlacedInSweptCost = 60;
inline constexpr std::uint64_t kComparedCost = 3;
inline constexpr std::uint64_t kPartnerCost = 20;
/// And of an update without them: of each body by a sweep, or with cells, and of each pair. EPYC, AVX-512, a
/// falling pile of 10,000: 450 us with cells, where 900 to 1,000 with fat boxes that do not last.
inline constexpr std::uint64_t kSweptCost = 20;
inline constexpr std::uint64_t kAnewCost = 28;
inline constexpr std::uint64_t kAnewPairCost = 9;
/// While more than one in so many pairs begins or ends in an update, and one in which no fat box is left
/// would take more than this share of one without them, nobody waits until they settle. EPYC, piles of 1,000
/// to 5,000 in Bullet: else 1.05 to 1.1 times as long, and a 99th percentile 1.2 to 1.3 times; with a 32nd or
/// a 128th, with 0.5 or 0.8 as long.
inline constexpr std::size_t kPairsOfChanged = 64;
inline constexpr double kMostOfAnew = 0.65;
/// In a large world without them so many bodies have some, and after so many updates all where no more than
/// this share of them left theirs in one. 10,000 bodies: 0.11 to 0.13 where they keep their course, 0 where
/// they tremble, and of a pile 0.77, 0.63, 0.32 and 0.06 while it falls and settles.
inline constexpr std::size_t kTried = 64;
inline constexpr std::uint32_t kUpdatesTried = 12;
inline constexpr double kMostEscapesOfTried = 1.0 / 6;
/// And in one that is swept without them, which takes less than to make cells. EPYC, piles of 1,000 to 2,900
/// in Bullet: with a 12th 1.0 to 1.1 times as long, with a 30th as long.
inline constexpr double kMostEscapesOfSwept = 1.0 / 24;

// --- one-shot searches
// ------------------------------------------------------------------------------------------------------------

/// So many boxes of one set and fewer are compared all with all. EPYC, uniform, 64 to 300: little between.
inline constexpr std::size_t kOneCell = 128;
/// More boxes than this, divided by the workers that there are, come into cells, which several can fill; and
/// of two sets, whose pairs within each a sweep finds in vain, more than kMostSwept. EPYC, AVX-512, one
/// thread, one set, scenes that are long on an axis: 0.5 to 0.9 of the time at 100,000, 1.0 to 1.2 at
/// 300,000; two sets in all scenes, 3,000 to 30,000: 1.0 to 1.5; 600 to 2,000: 0.7 to 0.9, but for those with
/// many pairs within a set.
inline constexpr std::size_t kMostSweptAtOnce = 131'072;
/// A sweep has all pairs in memory before the first one is handed on; where there are more than so many a
/// box, cells do without. Chosen, not measured.
inline constexpr std::size_t kPairsSweptAtOnce = 64;
/// Where one of two sets has so many and fewer, all of them are compared with all of the other.
/// EPYC, uniform, clustered, wall and stacks: 60 of 10,000 take as long either way, 75 of 2,000, 100 of
/// 100,000.
inline constexpr std::size_t kMostPieced = 64;
/// These are compared so many at a time.
inline constexpr std::size_t kPieced = 4096;
/// Seconds that such a comparison takes.
inline constexpr double kCrossTestGuess = 0.1e-9;
/// Boxes of two sets are put into a coarse grid, to leave out those that lie apart, unless each reaches into
/// so many rows of its cells, in the mean.
inline constexpr std::uint64_t kRowsOfApart = 16;
/// Nor unless so many of a few boxes have none of the other set nearby, before so many have, of both sets
/// together so many boxes or more. EPYC, uniform and clustered, 1,000 against the others, with the grid and
/// without: 2.1 at 10,000, 1.0 to 1.5 at 100,000, 0.6 to 0.9 at 200,000, 0.6 at 800,000; a tenth against the
/// others 1.3 to 2.2.
inline constexpr unsigned kAloneOfAsked = 6;
inline constexpr unsigned kNearOfFew = 1;
inline constexpr unsigned kNearOfMany = 5;
inline constexpr std::size_t kManyAsked = 131'072;
/// Rounded boxes that overlap where those of doubles do not, for each box, before their coordinates are
/// ranked.
inline constexpr std::uint64_t kCandidatesOfRounded = 16;
inline constexpr std::uint64_t kFewOfRounded = 4096;

// --- candidates
// -----------------------------------------------------------------------------------------------

/// When fewer than one in so many bodies got a new box, candidates of two others are not tested, but where
/// they are among many that are. EPYC, AVX-512, uniform 1,000 to 100,000: with 3 a fifth moving takes 1.1
/// times as long and three in ten 1.15 to 1.2 times; with 7 three in twenty 1.1 times.
inline constexpr std::size_t kFewFresh = 5;
/// Candidates of two bodies that rest are parted from the others after so many updates in which nobody began
/// to move; after twice as many, and so many at most, where somebody of theirs does within so many times as
/// many. After many updates it is looked anew who rests. Chosen, not measured.
inline constexpr std::uint32_t kPatienceToPart = 8;
inline constexpr std::uint32_t kMostPatienceToPart = 128;
inline constexpr std::uint32_t kCalmOfPatience = 4;
inline constexpr std::uint32_t kMostCalm = 1024;
/// Candidates among which those with a new box are picked at a time. EPYC, uniform 10,000 and 100,000: with
/// 64 and with 1,024 it takes the same.
inline constexpr std::size_t kRun = 256;
/// To ask the cells once who overlaps a body's fat box takes as long as to test so many candidates. EPYC,
/// uniform: 1,000 bodies 170, 10,000 210, 100,000 550, 1,000,000 410.
inline constexpr std::size_t kCandidatesOfQuery = 200;
/// To bring the list up to date after updates in which the cells were asked takes as long as so many walks,
/// or more. EPYC, stacks of 1,000 in Bullet, with a margin: updates take 0.76 to 0.89 of the
/// time with none.
inline constexpr std::size_t kWalksOfWaiting = 4;
/// To test one that is picked takes as long as so many when all are tested. EPYC, AVX-512, stacks of 1,000 in
/// Bullet: 0.9 of the time that picking all takes.
inline constexpr std::size_t kTestsOfPicked = 2;
/// A box that is far is asked for so many candidates before it is tested. EPYC, uniform 1,000,000.
inline constexpr std::size_t kAhead = 16;
/// So many candidates and twice the pairs allowed are always looked at.
inline constexpr std::size_t kFewCandidates = 1000;

/// Fat boxes that overlap in more pairs than so many for each pair of boxes, and so many for each body,
/// become the boxes themselves again, unless a margin was asked for.
inline constexpr std::size_t kCandidatesOfPair = 4;
inline constexpr std::size_t kCandidatesOfBody = 64;
/// More bytes than this for each thread, body, box in a cell and candidate go back with the next update.
/// Twice what was seen, EPYC, all scenes.
inline constexpr std::size_t kFewBytes = std::size_t{512} << 10;
inline constexpr std::size_t kBytesOfBody = 2048;
inline constexpr std::size_t kBytesOfCopy = 128;
inline constexpr std::size_t kBytesOfCandidate = 192;
/// After so many updates in which few bodies move or none, all that is only of use while many do goes back
/// where more than kFewBytes are held: a second of a game. Who updates several times for each step of the
/// bodies keeps it. Chosen, not measured.
inline constexpr std::uint32_t kQuietToGiveBack = 64;

/// So many changes of a list of pairs may wait whatever its length, and one more for so many pairs. EPYC,
/// stacks of 1,000 in Bullet: with a quarter as many every 19th update takes 35 us more. Uniform 100,000, 100
/// movers: with half as many pairs the same time, and 3 bytes a pair more.
inline constexpr std::size_t kFewNotes = 512;
inline constexpr std::size_t kPairsOfNote = 8;
/// A list that is no longer, with its changes, takes them at once. Chosen, not measured.
inline constexpr std::size_t kListedAtOnce = 4096;
/// In a longer one a change is sorted, in at most seven passes, and kPairsOfNote pairs are copied with it:
/// with so many steps for each new one all are in the list before as many wait again.
inline constexpr std::size_t kStepsOfNote = 16;
/// In a world at rest so many updates do all of that: before memory is given back.
inline constexpr std::size_t kPartsAtRest = kQuietToGiveBack / 2;
/// When one update would bring more than this and half the list, everything is found anew.
inline constexpr std::size_t kManyNotes = 16'384;

// --- sorting pairs
// --------------------------------------------------------------------------------------------

/// So many buckets fill at a time without running out of cache lines. EPYC, uniform 100,000.
inline constexpr std::size_t kBuckets = 512;
/// Fewer keys than this are compared.
inline constexpr std::size_t kFewKeys = 24;
/// Narrow keys are sorted by digits with at most so many values for each of them. EPYC, 150 to 36,000 keys.
inline constexpr std::size_t kValuesOfKey = 4;
/// And by digits with more values than 2,048 where there are so many keys for each. EPYC, level 4,000 and
/// 10,000: 0.81 of the time; stacks, dust and uniform 10,000, with fewer than one, 1.03 to 1.4 times.
inline constexpr std::size_t kKeysOfWideValue = 2;
/// Keys of so many digits are sorted by all of them. EPYC.
inline constexpr unsigned kFewDigits = 3;
/// Others are told apart by so many bits more than it takes to number them. EPYC.
inline constexpr unsigned kBitsMore = 4;
/// Fewer keys than this are sorted by one thread, in one step: digit by digit, or into as many buckets as
/// there are keys. EPYC, 135 to 3,000,000 pairs of 300 to 300,000 bodies.
inline constexpr std::size_t kOneStep = 32768;
/// By one thread also more are, where two numbers have 32 bits together, as long as they lie in its caches:
/// up to a third less. EPYC, 36,000 to 500,000 keys. By two threads in buckets 36,000 to 150,000 take 1.1
/// to 1.35 times as long as by one of them.
inline constexpr std::size_t kOneStepAlone = 262144;
/// Where that is done a part at a time they are filled in so many parts, which takes this share of what it
/// takes to fill them and then to sort them. Chosen, not measured.
inline constexpr std::size_t kPartsOfDistribution = kMostWorkers;
inline constexpr double kShareOfDistribution = 0.4;
/// A bucket has at least so many first numbers.
inline constexpr std::uint64_t kNarrowest = 4096;

/// A list of pairs between two changes is copied so many pairs at a time, so many times, before the next
/// change is looked for by halves. EPYC, uniform 10,000 and 100,000, all moving.
inline constexpr std::size_t kCopied = 8;
inline constexpr std::size_t kCopies = 8;
/// With more than one change for so many pairs the list is walked pair by pair instead. EPYC, stacks that
/// tremble, 1,000 and 10,000, in which half of the pairs change: 0.88 and 0.91 of the time of an update.
inline constexpr std::size_t kPairsOfChange = 4;

// --- queries
// -----------------------------------------------------------------------------------------------------

/// Questions of a batch that a worker takes at a time: chosen, not measured. What one takes, in seconds of
/// one thread, roughly. EPYC, uniform 10,000, small boxes.
inline constexpr std::size_t kQuestionsOfPart = 64;
inline constexpr double kQuestionGuess = 300e-9;
/// Questions without a tree of the boxes take longer than in one by a nanosecond for each box or cell that
/// they look at, but for the first ones. EPYC, 1,000 to 100,000 bodies: rays, ways and what is nearest,
/// through the cells; with more bodies, and in `clustered`, it is more.
inline constexpr std::uint64_t kLooksInTree = 8;
/// A tree is made once questions have looked at so many boxes for each body, and for so many bodies more.
inline constexpr std::uint64_t kTreePrice = 240;
inline constexpr std::uint64_t kFewestPaidFor = 256;
/// What it takes to bring a tree up to date, in looks: for each body that changed; or for each of all, when
/// more than one in so many did. EPYC, 10,000 and 100,000 bodies: nanoseconds.
inline constexpr std::uint64_t kTreeChangePrice = 30;
inline constexpr std::uint64_t kTreeUpdatePrice = 4;
inline constexpr std::size_t kFewChangesOfTree = 4;
/// Where questions paid for it in the update before they will again, most likely: a part of its price will
/// do.
inline constexpr std::uint64_t kPartOfPrice = 4;
/// How much further the nodes of a tree reach, in all, before it is made anew: one that to be brought up to
/// date has cost as much as another one, and one that has not.
inline constexpr double kWornTree = 1.25;
inline constexpr double kWornOutTree = 1.5;
/// A tree for which questions had saved over more updates than these, and which wore out before it paid off,
/// halves what is saved for the next one, so many times at most.
inline constexpr unsigned kUpdatesToSave = 3;
inline constexpr unsigned kMostHalved = 5;
/// Updates in which questions did not pay for the tree before it is given up: chosen, not measured.
inline constexpr unsigned kMostUnasked = 64;
/// So many and more are answered in the order of the cells in which they begin: 4,096 rays take half as long
/// then. EPYC, uniform 10,000 to 1,000,000. Where it begins to pay was not measured.
inline constexpr std::size_t kQuestionsSorted = 256;

// --- ids
// ---------------------------------------------------------------------------------------------------------

/// Entries of the table of scattered ids are asked for so many ids ahead, when there are so many entries.
/// EPYC, all new, 1,000 to 100,000.
inline constexpr std::size_t kIdsAhead = 16;
inline constexpr std::size_t kFarEntries = 65536;
/// The table of so many scattered ids, all of them new, is made when one is looked up. EPYC, all new.
inline constexpr std::size_t kTableWaits = 1024;
/// Whether these differ is told by so many bits of a hash for each. EPYC, 300 to 1,000,000: with 8 or 4 as
/// much or more.
inline constexpr std::size_t kBitsOfId = 16;
/// More ids than this are cut into buckets of about so many first. EPYC, all new, 1,000,000.
inline constexpr std::size_t kIdsOfBucket = 131072;

}  // namespace cellsweep::tuning
