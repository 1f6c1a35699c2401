// Ranks of a parallel run as threads of one process, each with a controller of its own. Header-only.
#ifndef oversketch_testing_harness_ranks_h
#define oversketch_testing_harness_ranks_h

#include "vtkAbstractArray.h"
#include "vtkCommunicator.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <functional>
#include <map>
#include <mutex>
#include <queue>
#include <thread>
#include <tuple>
#include <vector>

namespace oversketch_test
{

// What is on its way between ranks.
class Post
{
public:
  void send(int from, int to, int tag, std::vector<char> message)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Boxes[{ from, to, tag }].push(std::move(message));
    this->Arrived.notify_all();
  }
  // False where nothing comes for minutes: the sender does not take part.
  bool receive(int from, int to, int tag, std::vector<char>& message)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    auto& box = this->Boxes[{ from, to, tag }];
    if (!this->Arrived.wait_for(lock, std::chrono::minutes(3), [&box] { return !box.empty(); }))
    {
      return false;
    }
    message = std::move(box.front());
    box.pop();
    return true;
  }

private:
  std::mutex Mutex;
  std::condition_variable Arrived;
  std::map<std::tuple<int, int, int>, std::queue<std::vector<char>>> Boxes;
};

class ThreadCommunicator : public vtkCommunicator
{
public:
  static ThreadCommunicator* New();
  vtkTypeMacro(ThreadCommunicator, vtkCommunicator);
  void join(Post* post, int rank, int ranks)
  {
    this->Mail = post;
    this->LocalProcessId = rank;
    this->MaximumNumberOfProcesses = ranks;
    this->NumberOfProcesses = ranks;
  }
  int SendVoidArray(const void* data, vtkIdType length, int type, int to, int tag) override
  {
    const auto* bytes = static_cast<const char*>(data);
    this->Mail->send(this->LocalProcessId, to, tag, { bytes, bytes + length * size(type) });
    return 1;
  }
  int ReceiveVoidArray(void* data, vtkIdType length, int type, int from, int tag) override
  {
    std::vector<char> message;
    if (!this->Mail->receive(from, this->LocalProcessId, tag, message) ||
        message.size() > static_cast<std::size_t>(length * size(type)))
    {
      return 0;
    }
    std::memcpy(data, message.data(), message.size());
    this->Count = static_cast<vtkIdType>(message.size()) / size(type);
    return 1;
  }

private:
  static vtkIdType size(int type) { return vtkAbstractArray::GetDataTypeSize(type); }
  Post* Mail = nullptr;
};
vtkStandardNewMacro(ThreadCommunicator);

class ThreadController : public vtkMultiProcessController
{
public:
  static ThreadController* New();
  vtkTypeMacro(ThreadController, vtkMultiProcessController);
  void join(Post* post, int rank, int ranks)
  {
    this->Own->join(post, rank, ranks);
    this->Communicator = this->Own;
    this->RMICommunicator = this->Own;
  }
  void Initialize(int*, char***) override {}
  void Initialize(int*, char***, int) override {}
  void Finalize() override {}
  void Finalize(int) override {}
  void SingleMethodExecute() override {}
  void MultipleMethodExecute() override {}
  void CreateOutputWindow() override {}

private:
  vtkNew<ThreadCommunicator> Own;
};
vtkStandardNewMacro(ThreadController);

// Runs body once per rank, all at the same time.
inline void onRanks(int ranks, const std::function<void(vtkMultiProcessController*)>& body)
{
  Post post;
  std::vector<std::thread> threads;
  threads.reserve(static_cast<std::size_t>(ranks));
  for (int rank = 0; rank < ranks; ++rank)
  {
    threads.emplace_back(
      [&post, &body, rank, ranks]
      {
        vtkNew<ThreadController> controller;
        controller->join(&post, rank, ranks);
        body(controller);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

} // namespace oversketch_test
#endif
