// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <functional>
#include <iostream>

#include <CLI/CLI.hpp>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace segdf::apps {

/// Exit status of every program.
enum ExitCode : int {
  kOk = 0,
  kFailed = 1,    ///< nothing could be done
  kUsage = 2,     ///< the command line is wrong
  kPartial = 3,   ///< the input broke off; what came before it is saved
  kStopped = 130  ///< Ctrl-C; what was done until then is saved
};

/// Every scan takes megabytes and gives them back. Returned to the system, each page would have to
/// be handed out and cleared anew, which costs as much as half of the segmentation itself.
inline void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kThreshold = 256 << 20;
  mallopt(M_MMAP_THRESHOLD, kThreshold);
  mallopt(M_TRIM_THRESHOLD, kThreshold);
#endif
}

/// Parses the command line and runs the program; whatever goes wrong is one line, "error: ...".
inline int runApp(CLI::App& app, int argc, char** argv, const std::function<int()>& body) {
  keepFreedMemory();
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for_help) {
    return app.exit(asked_for_help);
  } catch (const CLI::ParseError& error) {
    std::cerr << "error: " << error.what() << "; see " << app.get_name() << " --help\n";
    return kUsage;
  }
  try {
    return body();
  } catch (const std::exception& error) {
    std::cerr << "error: " << error.what() << '\n';
    return kFailed;
  }
}

}  // namespace segdf::apps
