#include "autosave.h"

#include "files.h"
#include "json_reader.h"
#include "models.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>

namespace fs = std::filesystem;

namespace oversketch_session
{

using oversketch_files::Failed;

namespace
{

// The lock lies beside its folder. The kernel drops it when the program ends, however it ends.
std::string lockOf(const std::string& folder)
{
  return folder + ".lock";
}

// A descriptor that holds the lock, or -1.
int takeLock(const std::string& folder)
{
  const int file = ::open(lockOf(folder).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) != 0)
  {
    ::close(file);
    return -1;
  }
  return file;
}

constexpr const char* aboutFolder = "autosave"; // beside what the session names

std::string textOf(const KeptOf& of)
{
  Json::Value json;
  json["path"] = of.path;
  json["modified"] = of.modified;
  return Json::writeString(Json::StreamWriterBuilder(), json);
}

// Nothing is known of what an older program left, and after a crash meanwhile there may be two.
KeptOf aboutIn(const std::string& folder)
{
  KeptOf found;
  std::error_code absent;
  for (const fs::directory_entry& entry : fs::directory_iterator(fs::path(folder) / aboutFolder, absent))
  {
    const std::string path = entry.path().string();
    const Json::Value root = JsonReader::parse(oversketch_files::wholeFile(path), path);
    const JsonReader json(root, path);
    found = { json.text("path"), json.yes("modified") };
    if (found.modified)
    {
      break;
    }
  }
  return found;
}

std::time_t timeOf(const std::string& folder)
{
  struct stat about = {};
  return ::stat((fs::path(folder) / sessionEntry).c_str(), &about) == 0 ? about.st_mtime : 0;
}

void removeAll(const std::string& folder)
{
  std::error_code ignored;
  fs::remove_all(folder, ignored);
  fs::remove(lockOf(folder), ignored);
}

} // namespace

std::string autosaveRoot()
{
  const char* state = std::getenv("XDG_STATE_HOME");
  const char* home = std::getenv("HOME");
  const fs::path base = state && *state ? fs::path(state) : fs::path(home ? home : ".") / ".local" / "state";
  return (base / "oversketch" / "autosave").string();
}

Autosave::Autosave(const std::string& root)
{
  std::error_code error;
  fs::create_directories(root, error);
  const auto now = std::chrono::system_clock::now().time_since_epoch().count();
  this->Folder = (fs::path(root) / (std::to_string(now) + "-" + std::to_string(::getpid()))).string();
  this->Lock = error ? -1 : takeLock(this->Folder);
  if (this->Lock < 0)
  {
    throw Failed(root + ": cannot keep the session there: " +
                 (error ? error.message() : std::string(std::strerror(errno))));
  }
  this->Thread = std::thread([this] { this->work(); });
}

Autosave::~Autosave()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Stop = true;
  }
  this->Wake.notify_one();
  this->Thread.join();
  std::error_code ignored;
  if (!fs::exists(this->Folder, ignored))
  {
    fs::remove(lockOf(this->Folder), ignored);
  }
  ::close(this->Lock);
}

void Autosave::keep(SessionFile file, const KeptOf& of)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Next = std::move(file);
    this->NextOf = of;
  }
  this->Wake.notify_one();
}

void Autosave::onKept(std::function<void()> kept)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Kept = std::move(kept);
}

std::string Autosave::wait()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Idle.wait(lock, [this] { return !this->Next && !this->Writing; });
  return this->Failure;
}

std::string Autosave::failure()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Failure;
}

void Autosave::discard()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Next.reset();
  }
  this->wait();
  std::error_code ignored;
  fs::remove_all(this->Folder, ignored);
}

void Autosave::work()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  for (;;)
  {
    this->Wake.wait(lock, [this] { return this->Stop || this->Next; });
    if (!this->Next)
    {
      return;
    }
    const SessionFile file = std::move(*this->Next);
    const std::string about = textOf(this->NextOf);
    this->Next.reset();
    this->Writing = true;
    lock.unlock();
    std::string failure;
    try
    {
      Package package = this->Encode.encode(file);
      // Named by its content, as the others.
      package[std::string(aboutFolder) + "/" + std::to_string(std::hash<std::string>()(about)) + ".json"] =
        std::make_shared<std::string>(about);
      writeFolder(this->Folder, package, sessionEntry);
    }
    catch (const std::exception& error)
    {
      failure = error.what();
    }
    lock.lock();
    this->Failure = failure;
    this->Writing = false;
    this->Idle.notify_all();
    if (this->Kept && failure.empty())
    {
      this->Kept();
    }
  }
}

std::vector<LeftBehind> leftBehind(const std::string& root)
{
  // By their locks, which are there first.
  std::vector<std::string> folders;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(root, error))
  {
    if (entry.path().extension() == ".lock")
    {
      folders.push_back(fs::path(entry.path()).replace_extension().string());
    }
  }
  std::sort(folders.rbegin(), folders.rend()); // their names begin with the time
  std::vector<LeftBehind> found;
  for (const std::string& folder : folders)
  {
    const int lock = takeLock(folder);
    if (lock < 0)
    {
      continue;
    }
    try
    {
      const KeptOf of = aboutIn(folder);
      if (!of.modified)
      {
        removeAll(folder);
      }
      else
      {
        const SessionFile file = readSession(folder);
        std::size_t steps = 0; // of all models
        for (std::size_t place = 0; place < modelCount(file.session); ++place)
        {
          steps += modelAt(file.session, place).nodes.size();
        }
        found.push_back({ folder, of.path, file.session.meshName, steps, timeOf(folder) });
      }
    }
    catch (const Failed&)
    {
      // It ended before its first session was whole: there is nothing to give back.
      removeAll(folder);
    }
    ::close(lock);
  }
  return found;
}

void removeLeftBehind(const LeftBehind& left)
{
  removeAll(left.folder);
}

} // namespace oversketch_session
