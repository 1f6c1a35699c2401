#include "backdrop.h"

#include "pen_view.h"
#include "picture_files.h"

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkTexture.h"

#include <QObject>

#include <algorithm>

namespace oversketch_studio
{

using namespace oversketch_session;

struct Backdrop::Card
{
  std::shared_ptr<const Picture> picture;
  SharedPicture decoded; // null: it is to come
  QObject waits;         // for it
  oversketch::PenView view;
  oversketch::Vector2 low, high; // px
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkTexture> texture;
  vtkNew<vtkActor> actor;
};

Backdrop::Backdrop() = default;

Backdrop::~Backdrop() = default;

void Backdrop::set(const Pictures& pictures, vtkRenderer* renderer)
{
  std::vector<std::unique_ptr<Card>> next;
  for (const auto& picture : pictures)
  {
    // Decoded pixels stay, also where how it is shown has changed.
    const auto known = std::find_if(this->Cards.begin(),
      this->Cards.end(),
      [&](const auto& card) { return card && card->picture->image.bytes == picture->image.bytes; });
    std::unique_ptr<Card> card = known != this->Cards.end() ? std::move(*known) : std::make_unique<Card>();
    const bool isNew = !card->picture;
    card->picture = picture;
    const vtkSmartPointer<vtkPolyData> frame = picture->frame.own();
    card->view = oversketch::PenView::of(frame);
    card->low = { frame->GetPoint(0)[0], frame->GetPoint(0)[1] };
    card->high = { frame->GetPoint(1)[0], frame->GetPoint(1)[1] };
    if (isNew)
    {
      card->decoded = whenDecoded(&card->waits,
        picture->image.bytes,
        [one = card.get(), renderer](const SharedPicture& made) // undo has brought it back
        {
          one->decoded = made;
          one->texture->SetInputData(made->pixels);
          renderer->GetRenderWindow()->GetInteractor()->Render();
        });
      card->texture->SetInputData(card->decoded ? card->decoded->pixels : nullptr);
      card->texture->SetColorModeToDirectScalars();
      card->texture->InterpolateOn();
      card->texture->MipmapOn();
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(card->plane->GetOutputPort());
      card->actor->SetMapper(mapper);
      card->actor->SetTexture(card->texture);
      card->actor->GetProperty()->LightingOff();
      card->actor->PickableOff();
      card->actor->UseBoundsOff(); // the camera looks at the model
      renderer->AddActor(card->actor);
    }
    card->actor->GetProperty()->SetOpacity(picture->opacity);
    this->place(*card);
    next.push_back(std::move(card));
  }
  for (const auto& gone : this->Cards)
  {
    if (gone)
    {
      renderer->RemoveActor(gone->actor);
    }
  }
  this->Cards = std::move(next);
}

void Backdrop::setMesh(vtkPolyData* mesh)
{
  mesh->GetBounds(this->Box);
  for (const auto& card : this->Cards)
  {
    this->place(*card);
  }
}

// In the plane through the farthest corner of the model's box.
void Backdrop::place(Card& card) const
{
  const oversketch::View view = card.view.kernelView();
  double depth = VTK_DOUBLE_MAX;
  for (int corner = 0; corner < 8; ++corner)
  {
    depth = std::min(depth,
      view.depth({ this->Box[corner & 1], this->Box[2 + (corner >> 1 & 1)], this->Box[4 + (corner >> 2)] }));
  }
  if (view.perspective())
  {
    depth = std::min(depth, -1e-6); // a model behind the eye
  }
  const auto low = view.toWorld(card.low, depth), right = view.toWorld({ card.high[0], card.low[1] }, depth),
             up = view.toWorld({ card.low[0], card.high[1] }, depth);
  card.plane->SetOrigin(low[0], low[1], low[2]);
  card.plane->SetPoint1(right[0], right[1], right[2]);
  card.plane->SetPoint2(up[0], up[1], up[2]);
}

void Backdrop::look(vtkRenderer* renderer)
{
  const auto now = oversketch::PenView::of(renderer);
  for (const auto& card : this->Cards)
  {
    card->actor->SetVisibility(card->decoded && card->picture->shown && now.fromTheSamePlace(card->view));
  }
}

} // namespace oversketch_studio
