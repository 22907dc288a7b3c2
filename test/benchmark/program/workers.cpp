// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/workers.h"

#include "program/progressBar.h"

#include <visp3/core/vpException.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <iostream>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {

namespace {
// A worker writes one of these for each step, and after the last one what went wrong.
const char step = '\0';

struct Worker
{
  std::size_t work = 0;
  pid_t process = 0;
  int pipe = -1;
  std::string said;
};

void writeAll(int file, const char *bytes, std::size_t count)
{
  while (count > 0) {
    const ssize_t written = ::write(file, bytes, count);
    if (written <= 0) {
      return;
    }
    bytes += written;
    count -= static_cast<std::size_t>(written);
  }
}

void printTo(const std::string &log)
{
  const int file = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (file >= 0) {
    ::dup2(file, STDOUT_FILENO);
    ::dup2(file, STDERR_FILENO);
    ::close(file);
  }
}

[[noreturn]] void beWorker(const Work &work, int pipe, const std::string &log)
{
  printTo(log);
  int status = 0;
  std::string wrong;
  try {
    work.execute([pipe] { writeAll(pipe, &step, 1); });
  } catch (const vpException &e) {
    wrong = e.getStringMessage();
    status = 1;
  } catch (const std::exception &e) {
    wrong = e.what();
    status = 1;
  }
  writeAll(pipe, wrong.data(), wrong.size());
  std::cout.flush();
  _exit(status); // What the parent opened is the parent's to close.
}

Worker startWorker(const std::vector<Work> &works, std::size_t index, const std::string &log)
{
  int ends[2];
  std::cout.flush();
  if (::pipe(ends) != 0) {
    throw vpException(vpException::fatalError, "No pipe for '%s': %s", works[index].name.c_str(), strerror(errno));
  }
  Worker worker;
  worker.work = index;
  worker.process = ::fork();
  if (worker.process < 0) {
    throw vpException(vpException::fatalError, "No process for '%s': %s", works[index].name.c_str(), strerror(errno));
  }
  if (worker.process == 0) {
    ::close(ends[0]);
    beWorker(works[index], ends[1], log);
  }
  ::close(ends[1]);
  worker.pipe = ends[0];
  return worker;
}

// \return Number of steps among what the worker wrote; -1 where it has ended.
int listen(Worker &worker)
{
  char buffer[4096];
  const ssize_t count = ::read(worker.pipe, buffer, sizeof(buffer));
  if (count <= 0) {
    return -1;
  }
  int steps = 0;
  for (ssize_t i = 0; i < count; ++i) {
    if (buffer[i] == step) {
      ++steps;
    } else {
      worker.said += buffer[i];
    }
  }
  return steps;
}

std::string endWorker(const Worker &worker)
{
  int status = 0;
  ::close(worker.pipe);
  ::waitpid(worker.process, &status, 0);
  if (WIFSIGNALED(status)) {
    return std::string("it crashed: ") + strsignal(WTERMSIG(status));
  }
  if (WEXITSTATUS(status) != 0 && worker.said.empty()) {
    return "it ended with status " + std::to_string(WEXITSTATUS(status));
  }
  return worker.said;
}
} // namespace

std::vector<std::string> runWork(const std::vector<Work> &works, int jobs, const std::string &log)
{
  std::size_t total = 0;
  for (const Work &work : works) {
    total += work.size;
  }
  ProgressBar progress(total);
  std::vector<std::string> failures(works.size());
  std::vector<Worker> workers;
  std::size_t next = 0;
  while (next < works.size() || !workers.empty()) {
    while (next < works.size() && workers.size() < static_cast<std::size_t>(jobs)) {
      progress.setText(works[next].name);
      workers.push_back(startWorker(works, next++, log));
    }
    std::vector<pollfd> files;
    for (const Worker &worker : workers) {
      files.push_back({worker.pipe, POLLIN, 0});
    }
    ::poll(files.data(), files.size(), -1);
    for (std::size_t i = workers.size(); i-- > 0;) {
      if (files[i].revents == 0) {
        continue;
      }
      const int steps = listen(workers[i]);
      if (steps >= 0) {
        progress.advance(static_cast<std::size_t>(steps));
        continue;
      }
      failures[workers[i].work] = endWorker(workers[i]);
      workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }
  return failures;
}

} // namespace bench
