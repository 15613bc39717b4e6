#pragma once

#include <functional>
#include <vector>

namespace hearth {

/// Seconds that something to measure, a trial, and what it is held against, the base, took in turn:
/// base, trial, base, ..., base.
struct TurnTimes {
  std::vector<double> bases;  ///< one more than trials; none is 0
  std::vector<double> trials;
};

/// Runs both in turn; each returns the seconds that it took. There are `repeats` trials or, where
/// they take longer than the base, as many as take as long as so many of it: one at least.
TurnTimes timedInTurn(const std::function<double()>& base, const std::function<double()>& trial,
                      int repeats);

/// Of each trial, as a fraction of the base before it and of the one after it. So what slows the
/// machine for longer slows both alike, and what strikes a single run is as likely to make a ratio
/// too small as too large.
std::vector<double> ratiosOf(const TurnTimes& times);

/// The ratio in the middle or, of an even number, the geometric mean of the two there: while a
/// machine gets slower, a trial takes more of the base before it, and less of the one after it.
double costOf(std::vector<double> ratios);

}  // namespace hearth
