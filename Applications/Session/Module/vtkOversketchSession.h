/**
 * @class vtkOversketchSession
 * @brief a session as an object: steps on a mesh or of a drawing, undo and redo, runs in the background,
 * files
 *
 * A session is the mesh that was opened, if any, and the steps that were taken, each of which is a system of
 * GetSystems() with its values and inputs. It is kept in files `.oversketch`, which `oversketch-studio` and
 * `oversketch replay` open, and whose format Applications/Session/README.md tells. No result is kept: the
 * same session gives the same bits.
 *
 * A change is made at once, as one step of undo, and runs nothing. Update() runs the steps and waits; Start()
 * runs them in the background, until Poll() says that a result has come. Of steps that were run before
 * nothing is run again. A step that fails is held, says why in GetSteps(), and is passed by.
 *
 * All methods are for one thread, which owns the session. Texts are UTF-8. A method that returns false, or 0
 * in place of an id, has changed nothing, and GetMessage() says why; after one that did its work GetMessage()
 * is what is to be known all the same, such as what a file's format drops, or empty.
 *
 * Methods copy what they take. Their results are the caller's to look at, and stay while no result comes
 * and nothing else is opened; a copy of it is the caller's to change.
 *
 * @sa vtkOversketchSystem
 */
#ifndef vtkOversketchSession_h
#define vtkOversketchSession_h

#include "OversketchSessionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For what is held

namespace oversketch_session
{
class SessionState;
}

class vtkCamera;
class vtkImageData;
class vtkPolyData;

class OVERSKETCHSESSION_EXPORT vtkOversketchSession : public vtkObject
{
public:
  static vtkOversketchSession* New();
  vtkTypeMacro(vtkOversketchSession, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Why the last call did nothing, or what is to be known of what it did.
   */
  const char* GetMessage();

  /**
   * Begins with a file: a session (`.oversketch`, or a folder of the same content); a mesh, which becomes the
   * start (OBJ, PLY, STL, OFF, VTP, glTF); a grid of heights, which becomes a first step. A mesh of more than
   * eight million triangles is worked on by a proxy where its steps are motions.
   */
  bool Open(const char* path);
  /**
   * Writes the session to a file `.oversketch`, with the look; with the digest of its result where that is up
   * to date.
   */
  bool Save(const char* path);
  /**
   * Writes the mesh that the model shows, by the path's extension; of a model that is worked on by a proxy
   * all of it.
   */
  bool Export(const char* path);
  /**
   * Begins with a mesh, of that name. Polygons are triangulated.
   */
  bool SetMesh(vtkPolyData* mesh, const char* name);
  /**
   * Begins with an empty drawing over a picture (PNG, JPEG, WebP, BMP, TIFF), step 1.
   */
  bool NewDrawing(const char* picturePath);
  /**
   * Begins with an empty drawing on a canvas from the origin to this width and height [world units], step 1.
   */
  bool NewCanvas(double width, double height);

  /**
   * Lines for an input of the step that is added or changed next, by the input's name: strokes with their
   * view or curves. Null takes away what the step has. That step takes all inputs that were set, and so does
   * one that is refused.
   */
  void SetInput(const char* name, vtkPolyData* lines);
  /**
   * Gives an input that is a picture or a grid of heights.
   */
  void SetInputFile(const char* name, const char* path);
  /**
   * Gives an input as an output of an earlier step, by its id; output 0 is its mesh.
   */
  void SetInputStep(const char* name, int step, int port);

  /**
   * Adds a step of a system, by its name, at the end. Values are a JSON object by property names, "{}" for
   * defaults; a choice is its word. Returns the step's id, from 1.
   */
  int AddStep(const char* system, const char* values);
  /**
   * Gives a step other values and the inputs that were set; all that is not named stays.
   */
  bool ChangeStep(int id, const char* values);
  /**
   * Adds lines to a drawing.
   */
  bool AddStroke(int id, vtkPolyData* line);
  /**
   * Switches a step off, so that the mesh passes by, or on.
   */
  bool SetStepOn(int id, bool on);
  /**
   * Takes a step away.
   */
  bool RemoveStep(int id);
  /**
   * Moves a step to a place in the list, from 0. None may stand before one whose output it takes.
   */
  bool MoveStep(int id, int place);
  ///@{
  /**
   * Lets a step act on both sides of the plane where coordinate axis (0, 1, 2: x, y, z) is offset, or not.
   */
  bool SetMirror(int id, int axis, double offset);
  bool ClearMirror(int id);
  ///@}

  ///@{
  /**
   * Undo and redo, without limit, and whether there is a change for them.
   */
  bool Undo();
  bool Redo();
  bool GetCanUndo();
  bool GetCanRedo();
  ///@}
  /**
   * Tells whether all of it is in its file, or as it was opened.
   */
  bool GetSaved();

  /**
   * The steps, a JSON list of objects: id, system, title (of the system), name, on, values (where one is
   * absent, it is the default), inputs (by name: lines, image_name, or step and port), mirror (axis and
   * offset, or null); and, of the result that is shown, failure (why it did nothing, or an empty text),
   * remarks (a list of texts), section (middle and length of the place that it took hold of, or null) and
   * elsewhere (whether that is another place than when it was drawn).
   */
  const char* GetSteps();
  /**
   * The lines of a step's input, until the next call; null where it has none.
   */
  vtkPolyData* GetStepInput(int id, const char* name);
  /**
   * The systems, a JSON list of objects: name, verb (of the command), title, help, mirrors, inputs (name,
   * help, kind: mesh, stroke, curves, picture, heights; optional) and parameters (property, title, help,
   * kind: bool, int, double, numbers, text, choice; default, is_length, choices: word and title, of a text
   * those that a form offers; least and most that a form offers, absent where there are none).
   */
  static const char* GetSystems();

  /**
   * Runs the steps and waits. False where it was cancelled, or a step did nothing, which GetMessage() names;
   * what the others made is there then.
   */
  bool Update();
  /**
   * Runs the steps in the background, instead of what runs.
   */
  void Start();
  /**
   * Tells whether something runs.
   */
  bool IsRunning();
  /**
   * Takes the result that has come since the last call; false where none has.
   */
  bool Poll();
  /**
   * Stops what runs; its steps stay.
   */
  void Cancel();
  /**
   * Share of the run that is done [0 to 1]; 1 where nothing runs.
   */
  double GetProgress();
  /**
   * The name of the step that runs and its stage; empty where nothing runs.
   */
  const char* GetStage();

  /**
   * The mesh that the model shows: the last result, before one the mesh that was opened; null where there is
   * none. Of a model that is worked on by a proxy the proxy.
   */
  vtkPolyData* GetMesh();
  /**
   * Hexadecimal MD5 of its points and polygons, as the session's file has it; empty where there is none.
   */
  const char* GetDigest();
  ///@{
  /**
   * Pieces of that mesh that wear one picture each, with point normals and without hidden parts; the picture
   * belongs to the piece's texture coordinates, null where it has none. Null for a number that is none.
   */
  int GetNumberOfPieces();
  vtkPolyData* GetPieceMesh(int piece);
  vtkImageData* GetPiecePicture(int piece);
  ///@}

  /**
   * Sets a camera as the session was looked at; false where nobody looked.
   */
  bool GetLook(vtkCamera* camera);
  /**
   * Tells how it is looked at, in a view of that size [px].
   */
  void SetLook(vtkCamera* camera, int width, int height);

  ///@{
  /**
   * The models of the scene, and the place, from 0, of the one that is worked on, which all other methods are
   * about. Another one rests with its result: it is run first where that is not up to date.
   */
  int GetNumberOfModels();
  int GetModel();
  bool SetModel(int place);
  ///@}

protected:
  vtkOversketchSession();
  ~vtkOversketchSession() override;

private:
  vtkOversketchSession(const vtkOversketchSession&) = delete;
  void operator=(const vtkOversketchSession&) = delete;

  template <typename Act>
  bool Try(Act act);
  const std::unique_ptr<oversketch_session::SessionState> Held;
};

#endif
