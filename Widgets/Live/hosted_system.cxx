#include "hosted_system.h"

#include "Mesh/context.h"
#include "vtkOversketchStepRunner.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkTrivialProducer.h"

#include <tuple>

namespace oversketch
{

HostedSystem::HostedSystem()
{
  this->Producer->SetOutput(this->Output);
}

HostedSystem::~HostedSystem()
{
  this->stopWatching();
}

void HostedSystem::setSource(vtkAlgorithmOutput* source)
{
  this->Source = source ? source->GetProducer() : nullptr;
  this->SourcePort = source ? source->GetIndex() : 0;
}

void HostedSystem::setSource(vtkPolyData* mesh)
{
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(mesh);
  this->setSource(producer->GetOutputPort());
}

vtkAlgorithmOutput* HostedSystem::outputPort()
{
  return this->Producer->GetOutputPort();
}

bool HostedSystem::follow()
{
  if (!this->Source)
  {
    return false;
  }
  this->Source->Update(this->SourcePort);
  auto* mesh = vtkPolyData::SafeDownCast(this->Source->GetOutputDataObject(this->SourcePort));
  if (!mesh || (mesh == this->SourceSeen && mesh->GetMTime() == this->SourceTime))
  {
    return false;
  }
  this->SourceSeen = mesh;
  this->SourceTime = mesh->GetMTime();
  this->Base->ShallowCopy(mesh);
  this->drop();
  return true;
}

Message HostedSystem::run(const std::function<void(const Message&)>& warned)
{
  this->System->Modified(); // what ran before may have had another mesh in the same data object
  Message message;
  std::tie(this->Acted, message) = runAndReport(this->System, warned);
  this->Output->ShallowCopy(this->Acted ? this->System->GetOutput() : this->Base.Get());
  this->look();
  return message;
}

bool HostedSystem::isNewer()
{
  return this->System->GetMTime() > this->SystemTime;
}

void HostedSystem::look()
{
  this->SystemTime = this->System->GetMTime();
}

void HostedSystem::commit()
{
  this->Base->ShallowCopy(this->Output);
  this->Acted = false;
}

void HostedSystem::drop()
{
  this->Output->ShallowCopy(this->Base);
  this->Acted = false;
}

bool HostedSystem::say(const Message& message)
{
  this->Said = message;
  const std::string before = std::exchange(this->Text, message.text());
  return !this->Text.empty() && this->Text != before;
}

void HostedSystem::stopWatching()
{
  if (this->Watched)
  {
    this->Watched->RemoveObserver(this->WatchTag);
    this->Watched = nullptr;
  }
}

std::pair<bool, Message> runAndReport(vtkAlgorithm* system, const std::function<void(const Message&)>& warned)
{
  Message said;
  try
  {
    StepRunner::Listener listener;
    listener.warning = [&](const Message& warning)
    {
      said = warning;
      if (warned)
      {
        warned(warning);
      }
    };
    StepRunner(system, listener).Run();
    return { true, said };
  }
  catch (const Error& error)
  {
    return { false, error.message() };
  }
}

} // namespace oversketch
