#include "terminal.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

namespace oversketch_command
{

using namespace oversketch_files;

namespace
{

volatile std::sig_atomic_t stop = 0;

std::vector<std::string> warnings;

void interrupt(int)
{
  stop = 1;
  std::signal(SIGINT, endBySignal);
}

bool onTerminal()
{
  static const bool is = ::isatty(2) != 0;
  return is;
}

} // namespace

void catchSignals()
{
  endCleanly();
  if (std::signal(SIGINT, interrupt) == SIG_IGN)
  {
    std::signal(SIGINT, SIG_IGN); // a shell's background job
  }
}

bool interrupted()
{
  return stop != 0;
}

void throwIfInterrupted()
{
  if (interrupted())
  {
    throw Failed("interrupted; nothing is written");
  }
}

void say(const std::string& text)
{
  clearProgress();
  std::fprintf(stderr, "oversketch: %s\n", printable(text).c_str());
}

void warn(const std::string& text)
{
  if (std::find(warnings.begin(), warnings.end(), text) == warnings.end())
  {
    warnings.push_back(text);
    say("warning: " + text);
  }
}

const std::vector<std::string>& warned()
{
  return warnings;
}

void say(Notes& notes)
{
  for (const std::string& note : notes)
  {
    say("note: " + note);
  }
  notes.clear();
}

void showProgress(double share, const std::string& what)
{
  if (onTerminal())
  {
    std::fprintf(stderr, "\r%3.0f %%  %-20s", 100.0 * share, what.c_str());
    std::fflush(stderr);
  }
}

void clearProgress()
{
  if (onTerminal())
  {
    std::fprintf(stderr, "\r%40s\r", "");
    std::fflush(stderr);
  }
}

} // namespace oversketch_command
