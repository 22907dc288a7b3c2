// SPDX-License-Identifier: GPL-2.0-or-later
#include <catchMain.h>

#include "program/commandLine.h"
#include "evaluate/evaluateOptions.h"
#include "program/workers.h"

#include <meshFiles.h>

#include <visp3/core/vpException.h>

#include <csignal>
#include <fstream>

namespace {
bench::Work good(const meshFiles::TemporaryFolder &folder, const std::string &name)
{
  bench::Work work;
  work.name = name;
  work.size = 3;
  work.execute = [&folder, name](const std::function<void()> &oneMore) {
    for (int i = 0; i < 3; ++i) {
      oneMore();
    }
    std::cout << "chatter of " << name << "\n";
    folder.write(name, "done");
  };
  return work;
}

bool read(const std::vector<const char *> &arguments, bench::EvaluateOptions &options)
{
  std::vector<const char *> all = {"multicue-evaluate"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return options.read(static_cast<int>(all.size()), all.data());
}

std::string complaint(const std::vector<const char *> &arguments)
{
  bench::EvaluateOptions options;
  try {
    read(arguments, options);
  } catch (const vpException &e) {
    return e.getStringMessage();
  }
  return "";
}
} // namespace

TEST_CASE("Work that throws or crashes does not keep the other work from being done", "[evaluate]")
{
  const meshFiles::TemporaryFolder folder;
  bench::Work throwing = good(folder, "throwing");
  throwing.execute = [](const std::function<void()> &) {
    throw vpException(vpException::ioError, "'%s' is missing", "a.png");
  };
  bench::Work crashing = good(folder, "crashing");
  crashing.execute = [](const std::function<void()> &) { std::raise(SIGKILL); };
  const std::vector<bench::Work> works = {good(folder, "a"), throwing, crashing, good(folder, "b"), good(folder, "c")};

  for (const int jobs : {1, 3}) {
    const std::vector<std::string> failures = bench::runWork(works, jobs, folder.path("log.txt"));
    REQUIRE(failures.size() == works.size());
    CHECK(failures[0].empty());
    CHECK(failures[1] == "'a.png' is missing");
    CHECK(failures[2].find("crashed") != std::string::npos);
    CHECK(failures[3].empty());
    CHECK(failures[4].empty());
    for (const char *name : {"a", "b", "c"}) {
      CHECK(std::ifstream(folder.path(name)).good());
      std::remove(folder.path(name).c_str());
    }
  }
  CHECK(std::ifstream(folder.path("log.txt")).good());
}

TEST_CASE("The options are read", "[evaluate]")
{
  bench::EvaluateOptions options;
  REQUIRE(read({"--dataset", "d", "--scene", "a,b", "--tracker", "edge,visp-edge", "--protocol", "both", "--step",
                "1,2,4", "--jobs", "2", "--resume", "--start-error", "6.5", "--seed", "4", "--out", "o"},
               options));
  CHECK(options.scenes == std::vector<std::string>{"a", "b"});
  CHECK(options.trackers == std::vector<std::string>{"edge", "visp-edge"});
  CHECK(options.protocols.size() == 2);
  CHECK(options.steps == std::vector<int>{1, 2, 4});
  CHECK(options.jobs == 2);
  CHECK(options.resume);
  CHECK(options.start.pixels == exactly(6.5));
  CHECK(options.start.seed == 4);
}

TEST_CASE("Wrong options are named", "[evaluate]")
{
  CHECK(complaint({"--datset", "d"}).find("'--datset' is not known") != std::string::npos);
  CHECK(complaint({"--dataset"}).find("lacks its value") != std::string::npos);
  CHECK(complaint({"--dataset", "d", "--scene", "s"}).find("--tracker") != std::string::npos);
  CHECK(complaint({"--tracker", "edge"}).find("--dataset") != std::string::npos);
  CHECK(complaint({"--dataset", "d", "--scene", "s", "--out", "o", "--tracker", "egde"}).find("'egde'") !=
        std::string::npos);
  CHECK(
      complaint({"--dataset", "d", "--scene", "s", "--out", "o", "--tracker", "edge", "--step", "0"}).find("--step") !=
      std::string::npos);
  CHECK(complaint({"--dataset", "d", "--scene", "s", "--out", "o", "--tracker", "edge", "--start-error", "-2"})
            .find("--start-error: -2") != std::string::npos);
  CHECK(complaint({"--step", "1,x"}).find("'x'") != std::string::npos);
  CHECK(complaint({"--protocol", "fair", "--dataset", "d", "--scene", "s"}).find("'fair'") != std::string::npos);
  CHECK(complaint({"--jobs", "0"}).find("--jobs") != std::string::npos);
}
