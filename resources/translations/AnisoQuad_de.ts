<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
 <context>
  <name>AnisoQuadPreferences</name>
  <message>
   <source> px</source>
   <translation> px</translation>
  </message>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>1st</source>
   <translation>1.</translation>
  </message>
  <message>
   <source>1st: four nodes a quad; 2nd: eight, the mid-side nodes on the surface</source>
   <translation>1.: vier Knoten je Viereck; 2.: acht, die Seitenmittenknoten auf der Fläche</translation>
  </message>
  <message>
   <source>2nd</source>
   <translation>2.</translation>
  </message>
  <message>
   <source>Defaults of new objects</source>
   <translation>Vorgaben für neue Objekte</translation>
  </message>
  <message>
   <source>Element order of a quad mesh</source>
   <translation>Elementordnung eines Vierecknetzes</translation>
  </message>
  <message>
   <source>General</source>
   <translation>Allgemein</translation>
  </message>
  <message>
   <source>Hide the triangles once the quads are there</source>
   <translation>Dreiecke ausblenden, sobald die Vierecke da sind</translation>
  </message>
  <message>
   <source>How many times longer than high the quads at the line become</source>
   <translation>Wievielmal länger als hoch die Vierecke an der Linie werden</translation>
  </message>
  <message>
   <source>Maximum anisotropy of a source</source>
   <translation>Größte Anisotropie einer Quelle</translation>
  </message>
  <message>
   <source>View</source>
   <translation>Ansicht</translation>
  </message>
  <message>
   <source>Width of source lines</source>
   <translation>Breite der Quelllinien</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_AddSource</name>
  <message>
   <source>Add anisotropy source</source>
   <translation>Anisotropiequelle hinzufügen</translation>
  </message>
  <message>
   <source>Adds a line along which rows of long, thin quads are built, such as the leading edge of a wing, and opens a panel to pick it in the view: a click starts the line, a further one extends it along the ridge, a double click takes the whole line, a click with Ctrl cuts it, Esc leaves picking. With edges of a Part object selected, the mesh edges on them are the line. With a quad mesh selected, that one gets the source.</source>
   <translation>Fügt eine Linie hinzu, an der Reihen langer, schmaler Vierecke entstehen, etwa die Vorderkante eines Flügels, und öffnet ein Fenster, um sie in der Ansicht zu wählen: ein Klick beginnt die Linie, ein weiterer verlängert sie entlang des Grats, ein Doppelklick nimmt die ganze Linie, ein Klick mit Strg kürzt sie, Esc beendet das Wählen. Sind Kanten eines Part-Objekts gewählt, so sind die Netzkanten auf ihnen die Linie. Ist ein Vierecknetz gewählt, so bekommt dieses die Quelle.</translation>
  </message>
  <message>
   <source>Pick a line on the selected mesh along which rows of long thin quads are built;
with edges of a Part object selected, they are the line</source>
   <translation>Auf dem gewählten Netz eine Linie wählen, an der Reihen langer, schmaler Vierecke entstehen;
sind Kanten eines Part-Objekts gewählt, so sind sie die Linie</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Edit</name>
  <message>
   <source>Change the selected quad mesh or source</source>
   <translation>Das gewählte Vierecknetz oder die Quelle ändern</translation>
  </message>
  <message>
   <source>Edit</source>
   <translation>Bearbeiten</translation>
  </message>
  <message>
   <source>Opens the panel of the selected quad mesh or source, as a double click in the tree does. Cancel takes back everything that was changed in it.</source>
   <translation>Öffnet das Fenster des gewählten Vierecknetzes oder der Quelle, wie ein Doppelklick im Baum. Abbrechen nimmt alles zurück, was darin geändert wurde.</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Export</name>
  <message>
   <source>Export</source>
   <translation>Exportieren</translation>
  </message>
  <message>
   <source>Export quad mesh</source>
   <translation>Vierecknetz exportieren</translation>
  </message>
  <message>
   <source>Write the selected quad mesh as .vtu, .inp, .msh, .su2 or .obj</source>
   <translation>Das gewählte Vierecknetz als .vtu, .inp, .msh, .su2 oder .obj schreiben</translation>
  </message>
  <message>
   <source>Writes the selected quad mesh to a file: .vtu for ParaView, .inp for CalculiX and Abaqus, .msh for Gmsh, .su2 for SU2, .obj for other programs. Patches, rows, feature lines and sources are kept as named sets where the format has them.</source>
   <translation>Schreibt das gewählte Vierecknetz in eine Datei: .vtu für ParaView, .inp für CalculiX und Abaqus, .msh für Gmsh, .su2 für SU2, .obj für andere Programme. Flächen, Reihen, Merkmalslinien und Quellen bleiben als benannte Mengen erhalten, wo das Format solche kennt.</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Preferences</name>
  <message>
   <source>Defaults of new quad meshes and sources</source>
   <translation>Vorgaben für neue Vierecknetze und Quellen</translation>
  </message>
  <message>
   <source>Opens the preferences of the workbench: the anisotropy of new sources, the element order of new quad meshes, whether the triangles are hidden once the quads are there, and the width of the lines of sources.</source>
   <translation>Öffnet die Einstellungen des Arbeitsbereichs: die Anisotropie neuer Quellen, die Elementordnung neuer Vierecknetze, ob die Dreiecke ausgeblendet werden, sobald die Vierecke da sind, und die Breite der Quelllinien.</translation>
  </message>
  <message>
   <source>Preferences</source>
   <translation>Einstellungen</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_QuadMesh</name>
  <message>
   <source>Make an all-quad surface mesh of the selected triangle mesh or Part shape,
with the sources that were added to it before</source>
   <translation>Aus dem gewählten Dreiecknetz oder Part-Körper ein reines Vierecknetz der Oberfläche machen,
mit den Quellen, die vorher hinzugefügt wurden</translation>
  </message>
  <message>
   <source>Makes a quad mesh of the selected triangle mesh, and opens its panel, in which meshing starts at once. A Part shape is triangulated first. Sources that were added to the triangles before get their rows of long, thin quads. The quad mesh follows its triangles, sources and options: when they change, it is made anew. With an active analysis it becomes a part of it.</source>
   <translation>Macht ein Vierecknetz aus dem gewählten Dreiecksnetz und öffnet sein Fenster, in dem das Vernetzen sofort beginnt. Ein Part-Körper wird zuerst in Dreiecke zerlegt. Quellen, die vorher zu den Dreiecken hinzugefügt wurden, bekommen ihre Reihen langer, schmaler Vierecke. Das Vierecknetz folgt seinen Dreiecken, Quellen und Optionen: ändern sie sich, so wird es neu gemacht. Ist eine Analyse aktiv, so wird es ein Teil von ihr.</translation>
  </message>
  <message>
   <source>Quad mesh from mesh</source>
   <translation>Vierecknetz aus Netz</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Quality</name>
  <message>
   <source>Colour the selected quad mesh by its quality, and list the worst quads</source>
   <translation>Das gewählte Vierecknetz nach seiner Güte färben und die schlechtesten Vierecke aufzählen</translation>
  </message>
  <message>
   <source>Colours the selected quad mesh by a measure of its quads: scaled Jacobian, aspect ratio, skew, size or row. Red is bad, blue is good. The panel shows the measure's histogram, and lists the worst quads; a click on one zooms to it. Closing the panel brings the mesh's own look back.</source>
   <translation>Färbt das gewählte Vierecknetz nach einem Maß seiner Vierecke: skalierte Jacobi-Determinante, Seitenverhältnis, Schiefe, Größe oder Reihe. Rot ist schlecht, blau ist gut. Das Fenster zeigt die Verteilung des Maßes und nennt die schlechtesten Vierecke; ein Klick auf eines führt zu ihm. Wird das Fenster geschlossen, so sieht das Netz wieder aus wie vorher.</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Güte</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_SuggestSources</name>
  <message>
   <source>Find the leading and trailing edges of the selected mesh</source>
   <translation>Vorder- und Hinterkanten des gewählten Netzes finden</translation>
  </message>
  <message>
   <source>Looks for long, smooth ridges of the selected mesh, as leading and trailing edges are, and lists them in a panel. Those that are ticked become sources. With a quad mesh selected, that one gets them.</source>
   <translation>Sucht lange, glatte Grate des gewählten Netzes, wie es Vorder- und Hinterkanten sind, und zeigt sie in einer Liste. Angekreuzte werden zu Quellen. Ist ein Vierecknetz gewählt, so bekommt dieses sie.</translation>
  </message>
  <message>
   <source>Suggest leading edges</source>
   <translation>Vorderkanten vorschlagen</translation>
  </message>
 </context>
 <context>
  <name>App::Property</name>
  <message>
   <source>1st: four nodes a quad; 2nd: eight</source>
   <translation>1.: vier Knoten je Viereck; 2.: acht</translation>
  </message>
  <message>
   <source>All figures of the run, as JSON</source>
   <translation>Alle Zahlen des Laufs, als JSON</translation>
  </message>
  <message>
   <source>Degrees that one edge may turn along the surface where patches are remeshed; 0: any</source>
   <translation>Grad, um die sich eine Kante längs der Fläche drehen darf, wo Flächen neu zerlegt werden; 0: beliebig</translation>
  </message>
  <message>
   <source>Degrees that one edge of Gmsh's triangles may turn along the surface; 0: any</source>
   <translation>Grad, um die sich eine Kante der Dreiecke von Gmsh längs der Fläche drehen darf; 0: beliebig</translation>
  </message>
  <message>
   <source>Degrees; edges whose facets turn by more are feature lines</source>
   <translation>Grad; Kanten, an denen sich die Dreiecke um mehr drehen, sind Merkmalslinien</translation>
  </message>
  <message>
   <source>Edges of a Part object instead: the mesh edges on them are the line</source>
   <translation>Stattdessen Kanten eines Part-Objekts: Die Netzkanten auf ihnen sind die Linie</translation>
  </message>
  <message>
   <source>Faces of the Part object whose normals differ by less where they meet are one patch; 0: each is one</source>
   <translation>Flächen des Part-Objekts, deren Normalen sich weniger unterscheiden, wo sie aneinanderstoßen, sind ein Flächenstück; 0: jede ist eines</translation>
  </message>
  <message>
   <source>Further feature edges, as pairs of input vertex ids</source>
   <translation>Weitere Merkmalskanten, als Paare von Punktnummern der Eingabe</translation>
  </message>
  <message>
   <source>Largest angle between the normals of neighbours, by OpenCASCADE</source>
   <translation>Größter Winkel zwischen den Normalen von Nachbarn, bei OpenCASCADE</translation>
  </message>
  <message>
   <source>Largest distance between the mesh and the base mesh</source>
   <translation>Größter Abstand zwischen dem Netz und dem Ausgangsnetz</translation>
  </message>
  <message>
   <source>Largest distance of OpenCASCADE's triangles from the shape; 0: a five-thousandth of its diagonal</source>
   <translation>Größter Abstand der Dreiecke von OpenCASCADE von der Form; 0: ein Fünftausendstel ihrer Diagonale</translation>
  </message>
  <message>
   <source>Largest edge of Gmsh's triangles; 0: a tenth of the shape's diagonal</source>
   <translation>Längste Kante der Dreiecke von Gmsh; 0: ein Zehntel der Diagonale der Form</translation>
  </message>
  <message>
   <source>Largest edge of well-shaped triangles by OpenCASCADE (Mefisto) instead; 0: as large as deflection and angle allow</source>
   <translation>Stattdessen längste Kante gut geformter Dreiecke von OpenCASCADE (Mefisto); 0: so groß, wie Abstand und Winkel erlauben</translation>
  </message>
  <message>
   <source>Length of the line</source>
   <translation>Länge der Linie</translation>
  </message>
  <message>
   <source>Limit between the sizes of neighbouring elements where patches are remeshed</source>
   <translation>Grenze zwischen den Größen benachbarter Elemente, wo Flächen neu zerlegt werden</translation>
  </message>
  <message>
   <source>Limit of sweeps of the final smoothing</source>
   <translation>Grenze der Durchgänge der letzten Glättung</translation>
  </message>
  <message>
   <source>Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may grow by 1.6</source>
   <translation>Grenze der Höhe einer Reihe gegenüber der vorigen; die letzten, die zu isotropen Vierecken überleiten, dürfen um 1,6 wachsen</translation>
  </message>
  <message>
   <source>Lines along which anisotropic rows are built</source>
   <translation>Linien, an denen anisotrope Reihen entstehen</translation>
  </message>
  <message>
   <source>Maximum anisotropy, used where no passes are given; 1: a feature line without rows</source>
   <translation>Größte Anisotropie, wenn keine Durchgänge angegeben sind; 1: eine Merkmalslinie ohne Reihen</translation>
  </message>
  <message>
   <source>Mean scaled Jacobian</source>
   <translation>Mittlere skalierte Jacobi-Determinante</translation>
  </message>
  <message>
   <source>Mend bad input instead of rejecting it; the report says what was changed</source>
   <translation>Schlechte Eingabe ausbessern statt sie abzulehnen; der Bericht sagt, was geändert wurde</translation>
  </message>
  <message>
   <source>Merge ratio of each pass, with rows or not: 4:6, 2, 2</source>
   <translation>Verschmelzungsverhältnis jedes Durchgangs, mit oder ohne Zahl der Reihen: 4:6, 2, 2</translation>
  </message>
  <message>
   <source>Number of corner nodes</source>
   <translation>Zahl der Eckknoten</translation>
  </message>
  <message>
   <source>Number of mesh edges</source>
   <translation>Zahl der Netzkanten</translation>
  </message>
  <message>
   <source>Number of quads</source>
   <translation>Zahl der Vierecke</translation>
  </message>
  <message>
   <source>Number of triangles of the base mesh</source>
   <translation>Zahl der Dreiecke des Ausgangsnetzes</translation>
  </message>
  <message>
   <source>OpenCASCADE: as few triangles as Deflection and Angle allow; Gmsh: triangles of good shape, by Size and Curvature Angle</source>
   <translation>OpenCASCADE: so wenige Dreiecke, wie Deflection und Angle erlauben; Gmsh: gut geformte Dreiecke nach Size und Curvature Angle</translation>
  </message>
  <message>
   <source>Percent of elements saved</source>
   <translation>Prozent gesparter Elemente</translation>
  </message>
  <message>
   <source>Percent of interior nodes with four edges</source>
   <translation>Prozent der inneren Knoten mit vier Kanten</translation>
  </message>
  <message>
   <source>Point ids of the base mesh; closed when the first is also the last</source>
   <translation>Punktnummern des Ausgangsnetzes; geschlossen, wenn der erste auch der letzte ist</translation>
  </message>
  <message>
   <source>Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded</source>
   <translation>Flächen zuerst neu in Dreiecke zerlegen, deren Dreiecke keine Vierecke tragen können: zu lang und schmal, oder zu schnell wechselnd</translation>
  </message>
  <message>
   <source>Row, pass, source, patch of the quads; lines</source>
   <translation>Reihe, Durchgang, Quelle, Flächenstück der Vierecke; Linien</translation>
  </message>
  <message>
   <source>Rows of each pass, and why they stopped</source>
   <translation>Reihen jedes Durchgangs, und warum sie enden</translation>
  </message>
  <message>
   <source>Scaled Jacobian of the worst quad</source>
   <translation>Skalierte Jacobi-Determinante des schlechtesten Vierecks</translation>
  </message>
  <message>
   <source>Sides of the line, seen along it with the surface's normal up, that get rows</source>
   <translation>Seiten der Linie, längs gesehen mit der Flächennormale nach oben, die Reihen bekommen</translation>
  </message>
  <message>
   <source>Straighten a line that zigzags over the triangles before rows start</source>
   <translation>Eine Linie, die im Zickzack über die Dreiecke läuft, vor den Reihen gerade machen</translation>
  </message>
  <message>
   <source>The Part object</source>
   <translation>Das Part-Objekt</translation>
  </message>
  <message>
   <source>The Part object on which the mesh lies, where FEM looks for it</source>
   <translation>Das Part-Objekt, auf dem das Netz liegt, dort, wo FEM danach sucht</translation>
  </message>
  <message>
   <source>The base mesh of the last run</source>
   <translation>Das Ausgangsnetz des letzten Laufs</translation>
  </message>
  <message>
   <source>The line runs against its first edge: left and right change</source>
   <translation>Die Linie läuft ihrer ersten Kante entgegen: Links und rechts sind vertauscht</translation>
  </message>
  <message>
   <source>The line's points in the world</source>
   <translation>Die Punkte der Linie im Raum</translation>
  </message>
  <message>
   <source>The triangle mesh</source>
   <translation>Das Dreiecknetz</translation>
  </message>
  <message>
   <source>The triangle mesh on which the line lies</source>
   <translation>Das Dreiecknetz, auf dem die Linie liegt</translation>
  </message>
  <message>
   <source>Topological clean-up after the fill</source>
   <translation>Topologisches Aufräumen nach dem Füllen</translation>
  </message>
  <message>
   <source>Version of these properties</source>
   <translation>Version dieser Eigenschaften</translation>
  </message>
  <message>
   <source>Wanted edge length of the quads; remeshes all patches. 0: that of the triangles</source>
   <translation>Gewünschte Kantenlänge der Vierecke; alle Flächen werden neu zerlegt. 0: die der Dreiecke</translation>
  </message>
  <message>
   <source>Wanted edge lengths, one per input vertex, instead of size</source>
   <translation>Gewünschte Kantenlängen, eine je Punkt der Eingabe, statt der Größe</translation>
  </message>
  <message>
   <source>What the mesher warns of</source>
   <translation>Wovor der Vernetzer warnt</translation>
  </message>
  <message>
   <source>Where the base is the tessellation of a Part object: patches are its faces, and nodes lie exactly on it</source>
   <translation>Wo die Dreiecke die eines Part-Objekts sind: Flächenstücke sind seine Flächen, und Knoten liegen genau auf ihm</translation>
  </message>
 </context>
 <context>
  <name>Options</name>
  <message>
   <source>Cleanup</source>
   <translation>Aufräumen</translation>
  </message>
  <message>
   <source>Curvature angle</source>
   <translation>Krümmungswinkel</translation>
  </message>
  <message>
   <source>Degrees that one edge may turn along the surface where patches are remeshed; 0: any</source>
   <translation>Grad, um die sich eine Kante längs der Fläche drehen darf, wo Flächen neu zerlegt werden; 0: beliebig</translation>
  </message>
  <message>
   <source>Degrees; edges whose facets turn by more are feature lines</source>
   <translation>Grad; Kanten, an denen sich die Dreiecke um mehr drehen, sind Merkmalslinien</translation>
  </message>
  <message>
   <source>Feature angle</source>
   <translation>Kantenwinkel</translation>
  </message>
  <message>
   <source>Feature edges</source>
   <translation>Merkmalskanten</translation>
  </message>
  <message>
   <source>Further feature edges, as pairs of input vertex ids</source>
   <translation>Weitere Merkmalskanten, als Paare von Punktnummern der Eingabe</translation>
  </message>
  <message>
   <source>Growth</source>
   <translation>Wachstum</translation>
  </message>
  <message>
   <source>Limit between the sizes of neighbouring elements where patches are remeshed</source>
   <translation>Grenze zwischen den Größen benachbarter Elemente, wo Flächen neu zerlegt werden</translation>
  </message>
  <message>
   <source>Limit of sweeps of the final smoothing</source>
   <translation>Grenze der Durchgänge der letzten Glättung</translation>
  </message>
  <message>
   <source>Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may grow by 1.6</source>
   <translation>Grenze der Höhe einer Reihe gegenüber der vorigen; die letzten, die zu isotropen Vierecken überleiten, dürfen um 1,6 wachsen</translation>
  </message>
  <message>
   <source>Mend bad input instead of rejecting it; the report says what was changed</source>
   <translation>Schlechte Eingabe ausbessern statt sie abzulehnen; der Bericht sagt, was geändert wurde</translation>
  </message>
  <message>
   <source>Prepare</source>
   <translation>Vorbereiten</translation>
  </message>
  <message>
   <source>Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded</source>
   <translation>Flächen zuerst neu in Dreiecke zerlegen, deren Dreiecke keine Vierecke tragen können: zu lang und schmal, oder zu schnell wechselnd</translation>
  </message>
  <message>
   <source>Repair</source>
   <translation>Ausbessern</translation>
  </message>
  <message>
   <source>Row growth</source>
   <translation>Wachstum der Reihen</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>Smoothing passes</source>
   <translation>Glättungsdurchgänge</translation>
  </message>
  <message>
   <source>Topological clean-up after the fill</source>
   <translation>Topologisches Aufräumen nach dem Füllen</translation>
  </message>
  <message>
   <source>Vertex size</source>
   <translation>Größe an den Punkten</translation>
  </message>
  <message>
   <source>Wanted edge length of the quads; remeshes all patches. 0: that of the triangles</source>
   <translation>Gewünschte Kantenlänge der Vierecke; alle Flächen werden neu zerlegt. 0: die der Dreiecke</translation>
  </message>
  <message>
   <source>Wanted edge lengths, one per input vertex, instead of size</source>
   <translation>Gewünschte Kantenlängen, eine je Punkt der Eingabe, statt der Größe</translation>
  </message>
 </context>
 <context>
  <name>QuadMeshPanel</name>
  <message>
   <source>1:16 is the maximum anisotropy; 4:6, 2, 2 are the merge ratios of the passes, the first with six rows</source>
   <translation>1:16 ist die größte Anisotropie; 4:6, 2, 2 sind die Verschmelzungen der Durchgänge, der erste mit sechs Reihen</translation>
  </message>
  <message>
   <source>1st</source>
   <translation>1.</translation>
  </message>
  <message>
   <source>1st: four nodes a quad; 2nd: eight, the mid-side nodes on the surface</source>
   <translation>1.: vier Knoten je Viereck; 2.: acht, die Seitenmittenknoten auf der Fläche</translation>
  </message>
  <message>
   <source>2nd</source>
   <translation>2.</translation>
  </message>
  <message>
   <source>A quad mesh is made of a triangle mesh, and follows it: when the triangles, a source or an option change, it is made anew. Apply meshes and keeps the panel open; OK closes it; Cancel takes everything back. While it meshes, the window stays alive, and Stop keeps the old mesh.</source>
   <translation>Ein Vierecknetz wird aus einem Dreiecknetz gemacht und folgt ihm: Ändern sich die Dreiecke, eine Quelle oder eine Option, so entsteht es neu. Anwenden vernetzt und lässt das Fenster offen; OK schließt es; Abbrechen nimmt alles zurück. Beim Vernetzen bleibt FreeCAD bedienbar, und Anhalten behält das alte Netz.</translation>
  </message>
  <message>
   <source>Add…</source>
   <translation>Hinzufügen…</translation>
  </message>
  <message>
   <source>Anisotropy sources</source>
   <translation>Anisotropiequellen</translation>
  </message>
  <message>
   <source>CAD shape</source>
   <translation>CAD-Form</translation>
  </message>
  <message>
   <source>Change the selected source</source>
   <translation>Die gewählte Quelle ändern</translation>
  </message>
  <message>
   <source>Do not use the selected source any more</source>
   <translation>Die gewählte Quelle nicht mehr verwenden</translation>
  </message>
  <message>
   <source>Draw where rows will come</source>
   <translation>Zeichnen, wo Reihen entstehen werden</translation>
  </message>
  <message>
   <source>Edges</source>
   <translation>Kanten</translation>
  </message>
  <message>
   <source>Edit…</source>
   <translation>Bearbeiten…</translation>
  </message>
  <message>
   <source>Element order</source>
   <translation>Elementordnung</translation>
  </message>
  <message>
   <source>Faces of the shape that go on into each other smoothly, as a fillet and what it rounds, can be one patch, over which quads flow without a line between. Give the degrees by which their normals may differ where they meet, for instance 5. With 0 each face is a patch.</source>
   <translation>Flächen der Form, die glatt ineinander übergehen, wie eine Verrundung und was sie rundet, können ein Flächenstück sein, über das Vierecke ohne Linie dazwischen laufen. Anzugeben sind die Grad, um die sich ihre Normalen unterscheiden dürfen, wo sie aneinanderstoßen, zum Beispiel 5. Bei 0 ist jede Fläche ein Flächenstück.</translation>
  </message>
  <message>
   <source>Faces whose normals differ by less where they meet are one patch; 0: each is one</source>
   <translation>Flächen, deren Normalen sich weniger unterscheiden, wo sie aneinanderstoßen, sind ein Flächenstück; 0: jede ist eines</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Lines along which rows of long thin quads are built; a selected line is shown in the view</source>
   <translation>Linien, an denen Reihen langer, schmaler Vierecke entstehen; eine gewählte Linie wird in der Ansicht gezeigt</translation>
  </message>
  <message>
   <source>Meshing…</source>
   <translation>Vernetzen…</translation>
  </message>
  <message>
   <source>On: the patches of the mesh are the faces of the Part shape, its lines are their edges, and all nodes lie exactly on it. Off: only the triangles count, and lines are where they bend.</source>
   <translation>An: Die Flächenstücke des Netzes sind die Flächen der Part-Form, seine Linien deren Kanten, und alle Knoten liegen genau auf ihr. Aus: Nur die Dreiecke zählen, und Linien sind, wo sie knicken.</translation>
  </message>
  <message>
   <source>Onto shape</source>
   <translation>Auf die Form</translation>
  </message>
  <message>
   <source>OpenCASCADE makes as few triangles as show the shape; they are remeshed before they become quads. Gmsh is a program of its own, on Debian the package gmsh: its triangles have a good shape, the size that is asked for in the options, and are finer where the surface turns, as at a leading edge. They are made anew at the next Apply; Stop ends Gmsh.</source>
   <translation>OpenCASCADE macht so wenige Dreiecke, wie die Form zeigen; sie werden neu zerlegt, bevor sie Vierecke werden. Gmsh ist ein eigenes Programm, bei Debian das Paket gmsh: Seine Dreiecke sind gut geformt, haben die Größe, die in den Optionen verlangt ist, und sind feiner, wo sich die Fläche dreht, wie an einer Vorderkante. Sie entstehen beim nächsten Anwenden neu; Anhalten beendet Gmsh.</translation>
  </message>
  <message>
   <source>Options</source>
   <translation>Optionen</translation>
  </message>
  <message>
   <source>Passes</source>
   <translation>Durchgänge</translation>
  </message>
  <message>
   <source>Patches are the faces of the shape, and all nodes lie exactly on it</source>
   <translation>Flächenstücke sind die Flächen der Form, und alle Knoten liegen genau auf ihr</translation>
  </message>
  <message>
   <source>Pick a new line in the view</source>
   <translation>Eine neue Linie in der Ansicht wählen</translation>
  </message>
  <message>
   <source>Preview rows</source>
   <translation>Reihen zeigen</translation>
  </message>
  <message>
   <source>Quad mesh</source>
   <translation>Vierecknetz</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Entfernen</translation>
  </message>
  <message>
   <source>Scaled Jacobian: worst {worst:.3f}, mean {mean:.3f}; regular nodes: {regular:.1f} %</source>
   <translation>Skalierte Jacobi-Determinante: schlechteste {worst:.3f}, Mittel {mean:.3f}; reguläre Knoten: {regular:.1f} %</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Seiten</translation>
  </message>
  <message>
   <source>Smooth angle</source>
   <translation>Glatt bis</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Quelle</translation>
  </message>
  <message>
   <source>Source {source} has no rows, {side}: {why}</source>
   <translation>Quelle {source} hat keine Reihen, {side}: {why}</translation>
  </message>
  <message>
   <source>Source {source}, pass {pass_} (1:{ratio}): rows {counts}</source>
   <translation>Quelle {source}, Durchgang {pass_} (1:{ratio}): Reihen {counts}</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Anhalten</translation>
  </message>
  <message>
   <source>Stop meshing; the old mesh stays</source>
   <translation>Vernetzen anhalten; das alte Netz bleibt</translation>
  </message>
  <message>
   <source>Stopped. The old mesh was kept.</source>
   <translation>Angehalten. Das alte Netz blieb.</translation>
  </message>
  <message>
   <source>The triangle mesh that is turned into quads</source>
   <translation>Das Dreiecknetz, aus dem Vierecke werden</translation>
  </message>
  <message>
   <source>Triangles</source>
   <translation>Dreiecke</translation>
  </message>
  <message>
   <source>Triangulator</source>
   <translation>Dreiecke von</translation>
  </message>
  <message>
   <source>Warning: {}</source>
   <translation>Warnung: {}</translation>
  </message>
  <message>
   <source>What makes the triangles of the shape; Gmsh takes size and curvature angle of the options</source>
   <translation>Was die Dreiecke der Form macht; Gmsh nimmt Größe und Krümmungswinkel der Optionen</translation>
  </message>
  <message>
   <source>Where the triangles are those of a Part shape, the quads can lie on the shape itself: its faces are the patches, its edges the lines of the mesh. Gmsh, where it is installed, makes triangles of good shape in the size that the options ask for, and of a fineness that follows the curvature; OpenCASCADE makes as few as show the shape, which are then remeshed.</source>
   <translation>Wo die Dreiecke die einer Part-Form sind, können die Vierecke auf der Form selbst liegen: Ihre Flächen sind die Flächenstücke, ihre Kanten die Linien des Netzes. Gmsh, wo es installiert ist, macht gut geformte Dreiecke in der Größe, die die Optionen verlangen, und so fein, wie es die Krümmung braucht; OpenCASCADE macht so wenige, wie die Form zeigen, die dann neu zerlegt werden.</translation>
  </message>
  <message>
   <source>{quads} quads from {triangles} triangles</source>
   <translation>{quads} Vierecke aus {triangles} Dreiecken</translation>
  </message>
  <message>
   <source>{quads} quads from {triangles} triangles ({reduction:.1f} % fewer elements)</source>
   <translation>{quads} Vierecke aus {triangles} Dreiecken ({reduction:.1f} % weniger Elemente)</translation>
  </message>
  <message>
   <source>°</source>
   <translation>°</translation>
  </message>
 </context>
 <context>
  <name>QualityPanel</name>
  <message>
   <source>Aspect ratio</source>
   <translation>Seitenverhältnis</translation>
  </message>
  <message>
   <source>Element</source>
   <translation>Element</translation>
  </message>
  <message>
   <source>Number of quads (logarithmic) over the measure</source>
   <translation>Anzahl der Vierecke (logarithmisch) über dem Maß</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Güte</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>Reihe</translation>
  </message>
  <message>
   <source>Scaled Jacobian</source>
   <translation>Skalierte Jacobi-Determinante</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Größe</translation>
  </message>
  <message>
   <source>Skew</source>
   <translation>Schiefe</translation>
  </message>
  <message>
   <source>The quads are coloured by the chosen measure: red is bad, blue is good. The scaled Jacobian is 1 for a rectangle and 0 for a quad that is folded flat; thin quads of anisotropic rows keep a good one.</source>
   <translation>Die Vierecke sind nach dem gewählten Maß gefärbt: rot ist schlecht, blau ist gut. Die skalierte Jacobi-Determinante ist 1 für ein Rechteck und 0 für ein zusammengefallenes Viereck; schmale Vierecke anisotroper Reihen behalten eine gute.</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Wert</translation>
  </message>
  <message>
   <source>What the quads are coloured by</source>
   <translation>Wonach die Vierecke gefärbt sind</translation>
  </message>
  <message>
   <source>Worst quads; a click zooms to them:</source>
   <translation>Schlechteste Vierecke; ein Klick führt hin:</translation>
  </message>
  <message>
   <source>matplotlib is not installed: no histogram</source>
   <translation>matplotlib ist nicht installiert: kein Histogramm</translation>
  </message>
  <message>
   <source>{low:.4g} … {high:.4g}, mean {mean:.4g}</source>
   <translation>{low:.4g} … {high:.4g}, Mittel {mean:.4g}</translation>
  </message>
 </context>
 <context>
  <name>Report</name>
  <message>
   <source>Source {source}, {side}, pass {pass_} (1:{ratio}): {rows} rows of {columns} columns; {why}</source>
   <translation>Quelle {source}, {side}, Durchgang {pass_} (1:{ratio}): {rows} Reihen zu {columns} Spalten; {why}</translation>
  </message>
  <message>
   <source>a boundary, a feature line or another row is too close ahead</source>
   <translation>ein Rand, eine Merkmalslinie oder eine andere Reihe liegt zu dicht davor</translation>
  </message>
  <message>
   <source>a column has become too slim</source>
   <translation>eine Spalte ist zu schmal geworden</translation>
  </message>
  <message>
   <source>a quad of the row would be too distorted</source>
   <translation>ein Viereck der Reihe würde zu stark verzerrt</translation>
  </message>
  <message>
   <source>another row or the boundary lies directly ahead</source>
   <translation>eine andere Reihe oder der Rand liegt unmittelbar davor</translation>
  </message>
  <message>
   <source>as many rows as asked for</source>
   <translation>so viele Reihen wie verlangt</translation>
  </message>
  <message>
   <source>in {} of them the triangles turn too far from one to the next</source>
   <translation>in {} davon biegen die Dreiecke vom einen zum nächsten zu weit ab</translation>
  </message>
  <message>
   <source>in {} of them the triangles' size changes too fast</source>
   <translation>in {} davon ändert sich die Größe der Dreiecke zu schnell</translation>
  </message>
  <message>
   <source>invalid faces of the shape were taken as they are</source>
   <translation>ungültige Flächen der Form wurden genommen, wie sie sind</translation>
  </message>
  <message>
   <source>let Gmsh make them</source>
   <translation>sie von Gmsh bilden lassen</translation>
  </message>
  <message>
   <source>something lies inside the row</source>
   <translation>etwas liegt innerhalb der Reihe</translation>
  </message>
  <message>
   <source>the edges of {} triangles were turned because some were thinner than {} of the diagonal</source>
   <translation>die Kanten von {} Dreiecken wurden gedreht, weil einige dünner als {} der Diagonale waren</translation>
  </message>
  <message>
   <source>the end column reaches a corner of the feature lines</source>
   <translation>die Spalte am Ende erreicht eine Ecke der Merkmalslinien</translation>
  </message>
  <message>
   <source>the front turns too sharply for one more row</source>
   <translation>die Front biegt zu scharf ab für eine weitere Reihe</translation>
  </message>
  <message>
   <source>the input was repaired</source>
   <translation>die Eingabe wurde ausgebessert</translation>
  </message>
  <message>
   <source>the line at the row's end turns back to it</source>
   <translation>die Linie am Ende der Reihe kehrt zu ihr zurück</translation>
  </message>
  <message>
   <source>the shape's triangles are folded over at {} edges</source>
   <translation>die Dreiecke der Form sind an {} Kanten umgefaltet</translation>
  </message>
  <message>
   <source>the triangles ahead are too large for the length of the front's edges</source>
   <translation>die Dreiecke davor sind zu groß für die Länge der Kanten der Front</translation>
  </message>
  <message>
   <source>the triangles ahead could not be swapped into the row (column)</source>
   <translation>die Dreiecke davor ließen sich nicht zur Reihe umklappen (Spalte)</translation>
  </message>
  <message>
   <source>the triangles ahead could not be swapped into the row (top)</source>
   <translation>die Dreiecke davor ließen sich nicht zur Reihe umklappen (Oberkante)</translation>
  </message>
  <message>
   <source>{} edge cut apart</source>
   <translation>{} Kante aufgetrennt</translation>
  </message>
  <message>
   <source>{} edges cut apart</source>
   <translation>{} Kanten aufgetrennt</translation>
  </message>
  <message>
   <source>{} edges were collapsed because they are shorter than {} of the diagonal</source>
   <translation>{} Kanten wurden zusammengezogen, weil sie kürzer als {} der Diagonale sind</translation>
  </message>
  <message>
   <source>{} facet doubled dropped</source>
   <translation>{} doppelte Facette weggelassen</translation>
  </message>
  <message>
   <source>{} facet turned</source>
   <translation>{} Facette umgedreht</translation>
  </message>
  <message>
   <source>{} facet without all vertices dropped</source>
   <translation>{} Facette ohne alle Eckpunkte weggelassen</translation>
  </message>
  <message>
   <source>{} facet without area removed</source>
   <translation>{} Facette ohne Fläche entfernt</translation>
  </message>
  <message>
   <source>{} facet without finite coordinates dropped</source>
   <translation>{} Facette ohne endliche Koordinaten weggelassen</translation>
  </message>
  <message>
   <source>{} facets doubled dropped</source>
   <translation>{} doppelte Facetten weggelassen</translation>
  </message>
  <message>
   <source>{} facets turned</source>
   <translation>{} Facetten umgedreht</translation>
  </message>
  <message>
   <source>{} facets without all vertices dropped</source>
   <translation>{} Facetten ohne alle Eckpunkte weggelassen</translation>
  </message>
  <message>
   <source>{} facets without area removed</source>
   <translation>{} Facetten ohne Fläche entfernt</translation>
  </message>
  <message>
   <source>{} facets without finite coordinates dropped</source>
   <translation>{} Facetten ohne endliche Koordinaten weggelassen</translation>
  </message>
  <message>
   <source>{} of them have triangles too long and thin for quads ({} triangles)</source>
   <translation>{} davon haben Dreiecke, die für Vierecke zu lang und schmal sind ({} Dreiecke)</translation>
  </message>
  <message>
   <source>{} patches have an odd boundary that nothing can make even</source>
   <translation>{} Flächen haben einen Rand mit ungerader Kantenzahl, der sich nicht ändern lässt</translation>
  </message>
  <message>
   <source>{} patches were remeshed before: {} triangles became {}, edges up to {}</source>
   <translation>{} Flächen wurden zuvor neu in Dreiecke zerlegt: aus {} Dreiecken wurden {}, Kanten bis {}</translation>
  </message>
  <message>
   <source>{} quads are turned over by the surface to which they were brought</source>
   <translation>{} Vierecke werden von der Fläche umgedreht, auf die sie gebracht wurden</translation>
  </message>
  <message>
   <source>{} source nodes could not be merged</source>
   <translation>{} Knoten der Quelle ließen sich nicht verschmelzen</translation>
  </message>
  <message>
   <source>{} triangles are left</source>
   <translation>{} Dreiecke sind übrig geblieben</translation>
  </message>
  <message>
   <source>{} vertex added</source>
   <translation>{} Punkt hinzugefügt</translation>
  </message>
  <message>
   <source>{} vertex welded</source>
   <translation>{} Punkt verschweißt</translation>
  </message>
  <message>
   <source>{} vertices added</source>
   <translation>{} Punkte hinzugefügt</translation>
  </message>
  <message>
   <source>{} vertices of open edges lie at the place of another one; the surface is not joined there; repair joins it</source>
   <translation>{} Knoten offener Kanten liegen auf einem anderen; die Fläche hängt dort nicht zusammen; Reparieren verbindet sie</translation>
  </message>
  <message>
   <source>{} vertices welded</source>
   <translation>{} Punkte verschweißt</translation>
  </message>
 </context>
 <context>
  <name>SourcePanel</name>
  <message>
   <source>(closed)</source>
   <translation>(geschlossen)</translation>
  </message>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>A source is a line on the triangles along which rows of long, thin quads are built on both sides. Pick it in the view, or choose edges of a Part object. The maximum anisotropy says how many times longer than high the quads at the line become; it falls off with every pass.</source>
   <translation>Eine Quelle ist eine Linie auf den Dreiecken, an deren beiden Seiten Reihen langer, schmaler Vierecke entstehen. Sie wird in der Ansicht gewählt oder aus Kanten eines Part-Objekts. Die größte Anisotropie sagt, wievielmal länger als hoch die Vierecke an der Linie werden; sie nimmt mit jedem Durchgang ab.</translation>
  </message>
  <message>
   <source>Anisotropy source</source>
   <translation>Anisotropiequelle</translation>
  </message>
  <message>
   <source>Aspect at the line</source>
   <translation>Seitenverhältnis an der Linie</translation>
  </message>
  <message>
   <source>Click a mesh edge to start, click another to extend the line along ridges and feature lines. Double-click takes the whole line, Ctrl-click cuts it, Esc leaves.</source>
   <translation>Eine Netzkante anklicken, um zu beginnen; eine weitere, um die Linie über Grate und Merkmalslinien zu verlängern. Doppelklick nimmt die ganze Linie, Strg-Klick schneidet sie ab, Esc beendet.</translation>
  </message>
  <message>
   <source>How many times longer than high the quads at the line become; 1: a feature line without rows</source>
   <translation>Wievielmal länger als hoch die Vierecke an der Linie werden; 1: eine Merkmalslinie ohne Reihen</translation>
  </message>
  <message>
   <source>Imprint: make a line that zigzags over the triangles straight before rows start</source>
   <translation>Einprägen: eine Linie, die im Zickzack über die Dreiecke läuft, vor den Reihen gerade machen</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Länge</translation>
  </message>
  <message>
   <source>Maximum anisotropy</source>
   <translation>Größte Anisotropie</translation>
  </message>
  <message>
   <source>Merge ratio of each pass, with its number of rows or not, e.g. 4:6, 2, 2. Empty: chosen from the maximum anisotropy</source>
   <translation>Verschmelzungsverhältnis jedes Durchgangs, mit oder ohne Zahl der Reihen, z. B. 4:6, 2, 2. Leer: aus der größten Anisotropie</translation>
  </message>
  <message>
   <source>Mesh edges</source>
   <translation>Netzkanten</translation>
  </message>
  <message>
   <source>Passes</source>
   <translation>Durchgänge</translation>
  </message>
  <message>
   <source>Pick a line first</source>
   <translation>Erst eine Linie wählen</translation>
  </message>
  <message>
   <source>Pick in the view</source>
   <translation>In der Ansicht wählen</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Seiten</translation>
  </message>
  <message>
   <source>Sides of the line, seen along it with the surface's normal up, that get rows</source>
   <translation>Seiten der Linie, längs gesehen mit der Flächennormale nach oben, die Reihen bekommen</translation>
  </message>
  <message>
   <source>Straighten zigzags</source>
   <translation>Zickzack gerade machen</translation>
  </message>
  <message>
   <source>automatic</source>
   <translation>automatisch</translation>
  </message>
  <message>
   <source>both</source>
   <translation>beide</translation>
  </message>
  <message>
   <source>left</source>
   <translation>links</translation>
  </message>
  <message>
   <source>right</source>
   <translation>rechts</translation>
  </message>
 </context>
 <context>
  <name>Stages</name>
  <message>
   <source>Building rows</source>
   <translation>Reihen bauen</translation>
  </message>
  <message>
   <source>Checking</source>
   <translation>Prüfen</translation>
  </message>
  <message>
   <source>Cleaning up</source>
   <translation>Aufräumen</translation>
  </message>
  <message>
   <source>Evening out patches</source>
   <translation>Flächen ausgleichen</translation>
  </message>
  <message>
   <source>Filling with quads</source>
   <translation>Mit Vierecken füllen</translation>
  </message>
  <message>
   <source>Finding features</source>
   <translation>Merkmale suchen</translation>
  </message>
  <message>
   <source>Measuring</source>
   <translation>Messen</translation>
  </message>
  <message>
   <source>Preparing triangles</source>
   <translation>Dreiecke vorbereiten</translation>
  </message>
  <message>
   <source>Repairing</source>
   <translation>Ausbessern</translation>
  </message>
  <message>
   <source>Smoothing</source>
   <translation>Glätten</translation>
  </message>
  <message>
   <source>Triangulating</source>
   <translation>In Dreiecke zerlegen</translation>
  </message>
  <message>
   <source>{stage} {percent} % – Esc stops it</source>
   <translation>{stage} {percent} % – Esc bricht ab</translation>
  </message>
 </context>
 <context>
  <name>SuggestPanel</name>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>Line {index}: {length}, {edges} edges</source>
   <translation>Linie {index}: {length}, {edges} Kanten</translation>
  </message>
  <message>
   <source>Long, smooth ridges of the surface. OK makes a source of each that is ticked.</source>
   <translation>Lange, glatte Grate der Fläche. OK macht aus jedem angehakten eine Quelle.</translation>
  </message>
  <message>
   <source>Maximum anisotropy</source>
   <translation>Größte Anisotropie</translation>
  </message>
  <message>
   <source>No long, smooth ridge was found. Pick the line in the view instead.</source>
   <translation>Kein langer, glatter Grat gefunden. Die Linie stattdessen in der Ansicht wählen.</translation>
  </message>
  <message>
   <source>Ridges of curvature and sharp edges that are long and smooth look like leading and trailing edges. Tick those that shall become sources.</source>
   <translation>Lange und glatte Krümmungsgrate und scharfe Kanten sehen aus wie Vorder- und Hinterkanten. Die anhaken, die Quellen werden sollen.</translation>
  </message>
  <message>
   <source>Suggested sources</source>
   <translation>Vorgeschlagene Quellen</translation>
  </message>
 </context>
</TS>
