// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace segdf::apps {

/// Progress on standard error: a bar that stays on its line on a terminal, a plain line every tenth
/// of the way otherwise.
class Progress {
 public:
  explicit Progress(std::size_t total);

  /// @param done of `total`
  void show(std::size_t done);
  /// Ends the line of the bar.
  void finish() const;

 private:
  void drawBar(std::size_t percent) const;

  std::size_t total_;
  bool terminal_;
  std::size_t last_ = 0;  ///< percent shown last
};

}  // namespace segdf::apps
