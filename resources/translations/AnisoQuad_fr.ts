<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
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
   <translation>1er</translation>
  </message>
  <message>
   <source>1st: four nodes a quad; 2nd: eight, the mid-side nodes on the surface</source>
   <translation>1er : quatre nœuds par quadrangle ; 2e : huit, les nœuds milieux sur la surface</translation>
  </message>
  <message>
   <source>2nd</source>
   <translation>2e</translation>
  </message>
  <message>
   <source>Defaults of new objects</source>
   <translation>Valeurs par défaut des nouveaux objets</translation>
  </message>
  <message>
   <source>Element order of a quad mesh</source>
   <translation>Ordre des éléments d’un maillage quadrangulaire</translation>
  </message>
  <message>
   <source>General</source>
   <translation>Général</translation>
  </message>
  <message>
   <source>Hide the triangles once the quads are there</source>
   <translation>Masquer les triangles dès que les quadrangles sont là</translation>
  </message>
  <message>
   <source>How many times longer than high the quads at the line become</source>
   <translation>Combien de fois plus longs que hauts deviennent les quadrangles le long de la ligne</translation>
  </message>
  <message>
   <source>Maximum anisotropy of a source</source>
   <translation>Anisotropie maximale d’une source</translation>
  </message>
  <message>
   <source>View</source>
   <translation>Vue</translation>
  </message>
  <message>
   <source>Width of source lines</source>
   <translation>Largeur des lignes des sources</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_AddSource</name>
  <message>
   <source>Add anisotropy source</source>
   <translation>Ajouter une source d’anisotropie</translation>
  </message>
  <message>
   <source>Adds a line along which rows of long, thin quads are built, such as the leading edge of a wing, and opens a panel to pick it in the view: a click starts the line, a further one extends it along the ridge, a double click takes the whole line, a click with Ctrl cuts it, Esc leaves picking. With edges of a Part object selected, the mesh edges on them are the line. With a quad mesh selected, that one gets the source.</source>
   <translation>Ajoute une ligne le long de laquelle naissent des rangées de quadrangles longs et fins, comme le bord d’attaque d’une aile, et ouvre un panneau pour la choisir dans la vue : un clic commence la ligne, un autre la prolonge le long de la crête, un double-clic prend toute la ligne, un clic avec Ctrl la coupe, Échap quitte. Si des arêtes d’un objet Part sont sélectionnées, les arêtes du maillage sur elles sont la ligne. Si un maillage quadrangulaire est sélectionné, c’est lui qui reçoit la source.</translation>
  </message>
  <message>
   <source>Pick a line on the selected mesh along which rows of long thin quads are built;
with edges of a Part object selected, they are the line</source>
   <translation>Choisir sur le maillage sélectionné une ligne le long de laquelle naissent des rangées de quadrangles longs et fins ;
si des arêtes d’un objet Part sont sélectionnées, elles sont la ligne</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Edit</name>
  <message>
   <source>Change the selected quad mesh or source</source>
   <translation>Modifier le maillage quadrangulaire ou la source sélectionnés</translation>
  </message>
  <message>
   <source>Edit</source>
   <translation>Modifier</translation>
  </message>
  <message>
   <source>Opens the panel of the selected quad mesh or source, as a double click in the tree does. Cancel takes back everything that was changed in it.</source>
   <translation>Ouvre le panneau du maillage quadrangulaire ou de la source sélectionnés, comme un double-clic dans l’arborescence. Annuler défait tout ce qui y a été changé.</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Export</name>
  <message>
   <source>Export</source>
   <translation>Exporter</translation>
  </message>
  <message>
   <source>Export quad mesh</source>
   <translation>Exporter le maillage quadrangulaire</translation>
  </message>
  <message>
   <source>Write the selected quad mesh as .vtu, .inp, .msh, .su2 or .obj</source>
   <translation>Écrire le maillage quadrangulaire sélectionné en .vtu, .inp, .msh, .su2 ou .obj</translation>
  </message>
  <message>
   <source>Writes the selected quad mesh to a file: .vtu for ParaView, .inp for CalculiX and Abaqus, .msh for Gmsh, .su2 for SU2, .obj for other programs. Patches, rows, feature lines and sources are kept as named sets where the format has them.</source>
   <translation>Écrit le maillage quadrangulaire sélectionné dans un fichier : .vtu pour ParaView, .inp pour CalculiX et Abaqus, .msh pour Gmsh, .su2 pour SU2, .obj pour d’autres programmes. Les faces, rangées, lignes caractéristiques et sources sont gardées comme ensembles nommés là où le format en a.</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Preferences</name>
  <message>
   <source>Defaults of new quad meshes and sources</source>
   <translation>Valeurs par défaut des nouveaux maillages et sources</translation>
  </message>
  <message>
   <source>Opens the preferences of the workbench: the anisotropy of new sources, the element order of new quad meshes, whether the triangles are hidden once the quads are there, and the width of the lines of sources.</source>
   <translation>Ouvre les préférences de l’atelier : l’anisotropie des nouvelles sources, l’ordre des éléments des nouveaux maillages quadrangulaires, si les triangles sont cachés une fois les quadrangles faits, et la largeur des lignes des sources.</translation>
  </message>
  <message>
   <source>Preferences</source>
   <translation>Préférences</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_QuadMesh</name>
  <message>
   <source>Make an all-quad surface mesh of the selected triangle mesh or Part shape,
with the sources that were added to it before</source>
   <translation>Faire un maillage de surface entièrement quadrangulaire du maillage de triangles ou de la forme Part sélectionnés,
avec les sources ajoutées auparavant</translation>
  </message>
  <message>
   <source>Makes a quad mesh of the selected triangle mesh, and opens its panel, in which meshing starts at once. A Part shape is triangulated first. Sources that were added to the triangles before get their rows of long, thin quads. The quad mesh follows its triangles, sources and options: when they change, it is made anew. With an active analysis it becomes a part of it.</source>
   <translation>Fait un maillage quadrangulaire du maillage de triangles sélectionné et ouvre son panneau, où le maillage commence aussitôt. Une forme Part est d’abord triangulée. Les sources ajoutées auparavant aux triangles reçoivent leurs rangées de quadrangles longs et fins. Le maillage suit ses triangles, ses sources et ses options : quand ils changent, il est refait. Si une analyse est active, il en devient une partie.</translation>
  </message>
  <message>
   <source>Quad mesh from mesh</source>
   <translation>Maillage quadrangulaire à partir d’un maillage</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_Quality</name>
  <message>
   <source>Colour the selected quad mesh by its quality, and list the worst quads</source>
   <translation>Colorer le maillage sélectionné selon sa qualité et lister les pires quadrangles</translation>
  </message>
  <message>
   <source>Colours the selected quad mesh by a measure of its quads: scaled Jacobian, aspect ratio, skew, size or row. Red is bad, blue is good. The panel shows the measure's histogram, and lists the worst quads; a click on one zooms to it. Closing the panel brings the mesh's own look back.</source>
   <translation>Colore le maillage quadrangulaire sélectionné selon une mesure de ses quadrangles : jacobien normalisé, rapport d’aspect, biais, taille ou rangée. Rouge est mauvais, bleu est bon. Le panneau montre l’histogramme de la mesure et donne les pires quadrangles ; un clic y mène. Quand le panneau se ferme, le maillage reprend son aspect.</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Qualité</translation>
  </message>
 </context>
 <context>
  <name>AnisoQuad_SuggestSources</name>
  <message>
   <source>Find the leading and trailing edges of the selected mesh</source>
   <translation>Trouver les bords d’attaque et de fuite du maillage sélectionné</translation>
  </message>
  <message>
   <source>Looks for long, smooth ridges of the selected mesh, as leading and trailing edges are, and lists them in a panel. Those that are ticked become sources. With a quad mesh selected, that one gets them.</source>
   <translation>Cherche de longues crêtes lisses du maillage sélectionné, comme le sont les bords d’attaque et de fuite, et les montre dans une liste. Celles qui sont cochées deviennent des sources. Si un maillage quadrangulaire est sélectionné, c’est lui qui les reçoit.</translation>
  </message>
  <message>
   <source>Suggest leading edges</source>
   <translation>Proposer des bords d’attaque</translation>
  </message>
 </context>
 <context>
  <name>App::Property</name>
  <message>
   <source>1st: four nodes a quad; 2nd: eight</source>
   <translation>1er : quatre nœuds par quadrangle ; 2e : huit</translation>
  </message>
  <message>
   <source>All figures of the run, as JSON</source>
   <translation>Tous les chiffres du calcul, en JSON</translation>
  </message>
  <message>
   <source>Degrees that one edge may turn along the surface where patches are remeshed; 0: any</source>
   <translation>Degrés dont une arête peut tourner le long de la surface là où des faces sont remaillées ; 0 : autant que l’on veut</translation>
  </message>
  <message>
   <source>Degrees that one edge of Gmsh's triangles may turn along the surface; 0: any</source>
   <translation>Degrés dont une arête des triangles de Gmsh peut tourner le long de la surface ; 0 : autant que l’on veut</translation>
  </message>
  <message>
   <source>Degrees; edges whose facets turn by more are feature lines</source>
   <translation>Degrés ; les arêtes où les triangles tournent davantage sont des lignes caractéristiques</translation>
  </message>
  <message>
   <source>Edges of a Part object instead: the mesh edges on them are the line</source>
   <translation>Ou des arêtes d’un objet Part : les arêtes du maillage sur elles sont la ligne</translation>
  </message>
  <message>
   <source>Faces of the Part object whose normals differ by less where they meet are one patch; 0: each is one</source>
   <translation>Les faces de l’objet Part dont les normales diffèrent moins là où elles se joignent ne font qu’un morceau ; 0 : chacune en est un</translation>
  </message>
  <message>
   <source>Further feature edges, as pairs of input vertex ids</source>
   <translation>Autres arêtes caractéristiques, en paires de numéros de points donnés</translation>
  </message>
  <message>
   <source>Largest angle between the normals of neighbours, by OpenCASCADE</source>
   <translation>Plus grand angle entre les normales de voisins, par OpenCASCADE</translation>
  </message>
  <message>
   <source>Largest distance between the mesh and the base mesh</source>
   <translation>Plus grande distance entre le maillage et le maillage de base</translation>
  </message>
  <message>
   <source>Largest distance of OpenCASCADE's triangles from the shape; 0: a five-thousandth of its diagonal</source>
   <translation>Plus grande distance des triangles d’OpenCASCADE à la forme ; 0 : un cinq-millième de sa diagonale</translation>
  </message>
  <message>
   <source>Largest edge of Gmsh's triangles; 0: a tenth of the shape's diagonal</source>
   <translation>Plus longue arête des triangles de Gmsh ; 0 : un dixième de la diagonale de la forme</translation>
  </message>
  <message>
   <source>Largest edge of well-shaped triangles by OpenCASCADE (Mefisto) instead; 0: as large as deflection and angle allow</source>
   <translation>Ou plus longue arête de triangles bien formés par OpenCASCADE (Mefisto) ; 0 : aussi grande que l’écart et l’angle le permettent</translation>
  </message>
  <message>
   <source>Length of the line</source>
   <translation>Longueur de la ligne</translation>
  </message>
  <message>
   <source>Limit between the sizes of neighbouring elements where patches are remeshed</source>
   <translation>Limite entre les tailles d’éléments voisins là où des faces sont remaillées</translation>
  </message>
  <message>
   <source>Limit of sweeps of the final smoothing</source>
   <translation>Limite des passes du lissage final</translation>
  </message>
  <message>
   <source>Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may grow by 1.6</source>
   <translation>Limite de la hauteur d’une rangée par rapport à la précédente ; les dernières, qui mènent aux quadrilatères isotropes, peuvent croître de 1,6</translation>
  </message>
  <message>
   <source>Lines along which anisotropic rows are built</source>
   <translation>Lignes le long desquelles naissent des rangées anisotropes</translation>
  </message>
  <message>
   <source>Maximum anisotropy, used where no passes are given; 1: a feature line without rows</source>
   <translation>Anisotropie maximale, si aucune passe n’est donnée ; 1 : ligne caractéristique sans rangées</translation>
  </message>
  <message>
   <source>Mean scaled Jacobian</source>
   <translation>Jacobien normalisé moyen</translation>
  </message>
  <message>
   <source>Mend bad input instead of rejecting it; the report says what was changed</source>
   <translation>Réparer une mauvaise entrée au lieu de la refuser ; le rapport dit ce qui a été changé</translation>
  </message>
  <message>
   <source>Merge ratio of each pass, with rows or not: 4:6, 2, 2</source>
   <translation>Rapport de fusion de chaque passe, avec ou sans nombre de rangées : 4:6, 2, 2</translation>
  </message>
  <message>
   <source>Number of corner nodes</source>
   <translation>Nombre de nœuds de coin</translation>
  </message>
  <message>
   <source>Number of mesh edges</source>
   <translation>Nombre d’arêtes du maillage</translation>
  </message>
  <message>
   <source>Number of quads</source>
   <translation>Nombre de quadrangles</translation>
  </message>
  <message>
   <source>Number of triangles of the base mesh</source>
   <translation>Nombre de triangles du maillage de base</translation>
  </message>
  <message>
   <source>OpenCASCADE: as few triangles as Deflection and Angle allow; Gmsh: triangles of good shape, by Size and Curvature Angle</source>
   <translation>OpenCASCADE : aussi peu de triangles que Deflection et Angle le permettent ; Gmsh : triangles bien formés selon Size et Curvature Angle</translation>
  </message>
  <message>
   <source>Percent of elements saved</source>
   <translation>Pourcentage d’éléments épargnés</translation>
  </message>
  <message>
   <source>Percent of interior nodes with four edges</source>
   <translation>Pourcentage de nœuds intérieurs à quatre arêtes</translation>
  </message>
  <message>
   <source>Point ids of the base mesh; closed when the first is also the last</source>
   <translation>Numéros de points du maillage de base ; fermée quand le premier est aussi le dernier</translation>
  </message>
  <message>
   <source>Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded</source>
   <translation>Remailler d’abord les faces dont les triangles ne peuvent porter de quadrangles : trop longs et fins, ou de taille trop vite changeante</translation>
  </message>
  <message>
   <source>Row, pass, source, patch of the quads; lines</source>
   <translation>Rangée, passe, source, morceau des quadrangles ; lignes</translation>
  </message>
  <message>
   <source>Rows of each pass, and why they stopped</source>
   <translation>Rangées de chaque passe, et pourquoi elles finissent</translation>
  </message>
  <message>
   <source>Scaled Jacobian of the worst quad</source>
   <translation>Jacobien normalisé du plus mauvais quadrangle</translation>
  </message>
  <message>
   <source>Sides of the line, seen along it with the surface's normal up, that get rows</source>
   <translation>Côtés de la ligne, vue dans sa direction, normale vers le haut, qui reçoivent des rangées</translation>
  </message>
  <message>
   <source>Straighten a line that zigzags over the triangles before rows start</source>
   <translation>Redresser une ligne en zigzag sur les triangles avant les rangées</translation>
  </message>
  <message>
   <source>The Part object</source>
   <translation>L’objet Part</translation>
  </message>
  <message>
   <source>The Part object on which the mesh lies, where FEM looks for it</source>
   <translation>L’objet Part sur lequel est le maillage, là où FEM le cherche</translation>
  </message>
  <message>
   <source>The base mesh of the last run</source>
   <translation>Le maillage de base du dernier calcul</translation>
  </message>
  <message>
   <source>The line runs against its first edge: left and right change</source>
   <translation>La ligne va à l’encontre de sa première arête : gauche et droite changent</translation>
  </message>
  <message>
   <source>The line's points in the world</source>
   <translation>Les points de la ligne dans l’espace</translation>
  </message>
  <message>
   <source>The triangle mesh</source>
   <translation>Le maillage de triangles</translation>
  </message>
  <message>
   <source>The triangle mesh on which the line lies</source>
   <translation>Le maillage de triangles sur lequel est la ligne</translation>
  </message>
  <message>
   <source>Topological clean-up after the fill</source>
   <translation>Nettoyage topologique après le remplissage</translation>
  </message>
  <message>
   <source>Version of these properties</source>
   <translation>Version de ces propriétés</translation>
  </message>
  <message>
   <source>Wanted edge length of the quads; remeshes all patches. 0: that of the triangles</source>
   <translation>Longueur d’arête voulue des quadrangles ; remaille toutes les faces. 0 : celle des triangles</translation>
  </message>
  <message>
   <source>Wanted edge lengths, one per input vertex, instead of size</source>
   <translation>Longueurs d’arête voulues, une par point donné, au lieu de la taille</translation>
  </message>
  <message>
   <source>What the mesher warns of</source>
   <translation>Ce dont le mailleur avertit</translation>
  </message>
  <message>
   <source>Where the base is the tessellation of a Part object: patches are its faces, and nodes lie exactly on it</source>
   <translation>Si la base est la triangulation d’un objet Part : les morceaux sont ses faces, et les nœuds sont exactement sur lui</translation>
  </message>
 </context>
 <context>
  <name>Options</name>
  <message>
   <source>Cleanup</source>
   <translation>Nettoyage</translation>
  </message>
  <message>
   <source>Curvature angle</source>
   <translation>Angle de courbure</translation>
  </message>
  <message>
   <source>Degrees that one edge may turn along the surface where patches are remeshed; 0: any</source>
   <translation>Degrés dont une arête peut tourner le long de la surface là où des faces sont remaillées ; 0 : autant que l’on veut</translation>
  </message>
  <message>
   <source>Degrees; edges whose facets turn by more are feature lines</source>
   <translation>Degrés ; les arêtes où les triangles tournent davantage sont des lignes caractéristiques</translation>
  </message>
  <message>
   <source>Feature angle</source>
   <translation>Angle des arêtes vives</translation>
  </message>
  <message>
   <source>Feature edges</source>
   <translation>Arêtes caractéristiques</translation>
  </message>
  <message>
   <source>Further feature edges, as pairs of input vertex ids</source>
   <translation>Autres arêtes caractéristiques, en paires de numéros de points donnés</translation>
  </message>
  <message>
   <source>Growth</source>
   <translation>Croissance</translation>
  </message>
  <message>
   <source>Limit between the sizes of neighbouring elements where patches are remeshed</source>
   <translation>Limite entre les tailles d’éléments voisins là où des faces sont remaillées</translation>
  </message>
  <message>
   <source>Limit of sweeps of the final smoothing</source>
   <translation>Limite des passes du lissage final</translation>
  </message>
  <message>
   <source>Limit of the height of a row over that of the row before; the last few, which lead over to isotropic quads, may grow by 1.6</source>
   <translation>Limite de la hauteur d’une rangée par rapport à la précédente ; les dernières, qui mènent aux quadrilatères isotropes, peuvent croître de 1,6</translation>
  </message>
  <message>
   <source>Mend bad input instead of rejecting it; the report says what was changed</source>
   <translation>Réparer une mauvaise entrée au lieu de la refuser ; le rapport dit ce qui a été changé</translation>
  </message>
  <message>
   <source>Prepare</source>
   <translation>Préparer</translation>
  </message>
  <message>
   <source>Remesh patches first whose triangles can't hold quads: too long and thin, or too steeply graded</source>
   <translation>Remailler d’abord les faces dont les triangles ne peuvent porter de quadrangles : trop longs et fins, ou de taille trop vite changeante</translation>
  </message>
  <message>
   <source>Repair</source>
   <translation>Réparer</translation>
  </message>
  <message>
   <source>Row growth</source>
   <translation>Croissance des rangées</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Taille</translation>
  </message>
  <message>
   <source>Smoothing passes</source>
   <translation>Passes de lissage</translation>
  </message>
  <message>
   <source>Topological clean-up after the fill</source>
   <translation>Nettoyage topologique après le remplissage</translation>
  </message>
  <message>
   <source>Vertex size</source>
   <translation>Taille aux points</translation>
  </message>
  <message>
   <source>Wanted edge length of the quads; remeshes all patches. 0: that of the triangles</source>
   <translation>Longueur d’arête voulue des quadrangles ; remaille toutes les faces. 0 : celle des triangles</translation>
  </message>
  <message>
   <source>Wanted edge lengths, one per input vertex, instead of size</source>
   <translation>Longueurs d’arête voulues, une par point donné, au lieu de la taille</translation>
  </message>
 </context>
 <context>
  <name>QuadMeshPanel</name>
  <message>
   <source>1:16 is the maximum anisotropy; 4:6, 2, 2 are the merge ratios of the passes, the first with six rows</source>
   <translation>1:16 est l’anisotropie maximale ; 4:6, 2, 2 sont les rapports de fusion des passes, la première de six rangées</translation>
  </message>
  <message>
   <source>1st</source>
   <translation>1er</translation>
  </message>
  <message>
   <source>1st: four nodes a quad; 2nd: eight, the mid-side nodes on the surface</source>
   <translation>1er : quatre nœuds par quadrangle ; 2e : huit, les nœuds milieux sur la surface</translation>
  </message>
  <message>
   <source>2nd</source>
   <translation>2e</translation>
  </message>
  <message>
   <source>A quad mesh is made of a triangle mesh, and follows it: when the triangles, a source or an option change, it is made anew. Apply meshes and keeps the panel open; OK closes it; Cancel takes everything back. While it meshes, the window stays alive, and Stop keeps the old mesh.</source>
   <translation>Un maillage quadrangulaire est fait d’un maillage de triangles et le suit : quand les triangles, une source ou une option changent, il est refait. Appliquer maille et laisse le panneau ouvert ; OK le ferme ; Annuler défait tout. Pendant le maillage la fenêtre reste vivante, et Arrêter garde l’ancien.</translation>
  </message>
  <message>
   <source>Add…</source>
   <translation>Ajouter…</translation>
  </message>
  <message>
   <source>Anisotropy sources</source>
   <translation>Sources d’anisotropie</translation>
  </message>
  <message>
   <source>CAD shape</source>
   <translation>Forme CAO</translation>
  </message>
  <message>
   <source>Change the selected source</source>
   <translation>Modifier la source sélectionnée</translation>
  </message>
  <message>
   <source>Do not use the selected source any more</source>
   <translation>Ne plus utiliser la source sélectionnée</translation>
  </message>
  <message>
   <source>Draw where rows will come</source>
   <translation>Dessiner où viendront les rangées</translation>
  </message>
  <message>
   <source>Edges</source>
   <translation>Arêtes</translation>
  </message>
  <message>
   <source>Edit…</source>
   <translation>Modifier…</translation>
  </message>
  <message>
   <source>Element order</source>
   <translation>Ordre des éléments</translation>
  </message>
  <message>
   <source>Faces of the shape that go on into each other smoothly, as a fillet and what it rounds, can be one patch, over which quads flow without a line between. Give the degrees by which their normals may differ where they meet, for instance 5. With 0 each face is a patch.</source>
   <translation>Les faces de la forme qui se prolongent sans arête, comme un congé et ce qu’il arrondit, peuvent ne faire qu’un morceau, sur lequel les quadrangles passent sans ligne entre elles. Donnez les degrés dont leurs normales peuvent différer là où elles se joignent, par exemple 5. Avec 0, chaque face est un morceau.</translation>
  </message>
  <message>
   <source>Faces whose normals differ by less where they meet are one patch; 0: each is one</source>
   <translation>Les faces dont les normales diffèrent moins là où elles se joignent ne font qu’un morceau ; 0 : chacune en est un</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Longueur</translation>
  </message>
  <message>
   <source>Lines along which rows of long thin quads are built; a selected line is shown in the view</source>
   <translation>Lignes le long desquelles naissent des rangées de quadrangles longs et fins ; la ligne sélectionnée est montrée dans la vue</translation>
  </message>
  <message>
   <source>Meshing…</source>
   <translation>Maillage en cours…</translation>
  </message>
  <message>
   <source>On: the patches of the mesh are the faces of the Part shape, its lines are their edges, and all nodes lie exactly on it. Off: only the triangles count, and lines are where they bend.</source>
   <translation>Coché : les morceaux du maillage sont les faces de la forme Part, ses lignes en sont les arêtes, et tous les nœuds sont exactement sur elle. Décoché : seuls comptent les triangles, et les lignes sont là où ils plient.</translation>
  </message>
  <message>
   <source>Onto shape</source>
   <translation>Sur la forme</translation>
  </message>
  <message>
   <source>OpenCASCADE makes as few triangles as show the shape; they are remeshed before they become quads. Gmsh is a program of its own, on Debian the package gmsh: its triangles have a good shape, the size that is asked for in the options, and are finer where the surface turns, as at a leading edge. They are made anew at the next Apply; Stop ends Gmsh.</source>
   <translation>OpenCASCADE fait aussi peu de triangles qu’il en faut pour montrer la forme ; ils sont remaillés avant de devenir quadrangles. Gmsh est un programme à part, sous Debian le paquet gmsh : ses triangles sont bien formés, ont la taille demandée dans les options, et sont plus fins là où la surface tourne, comme à un bord d’attaque. Ils sont refaits au prochain Appliquer ; Arrêter met fin à Gmsh.</translation>
  </message>
  <message>
   <source>Options</source>
   <translation>Options</translation>
  </message>
  <message>
   <source>Passes</source>
   <translation>Passes</translation>
  </message>
  <message>
   <source>Patches are the faces of the shape, and all nodes lie exactly on it</source>
   <translation>Les morceaux sont les faces de la forme, et tous les nœuds sont exactement sur elle</translation>
  </message>
  <message>
   <source>Pick a new line in the view</source>
   <translation>Choisir une nouvelle ligne dans la vue</translation>
  </message>
  <message>
   <source>Preview rows</source>
   <translation>Aperçu des rangées</translation>
  </message>
  <message>
   <source>Quad mesh</source>
   <translation>Maillage quadrangulaire</translation>
  </message>
  <message>
   <source>Remove</source>
   <translation>Retirer</translation>
  </message>
  <message>
   <source>Scaled Jacobian: worst {worst:.3f}, mean {mean:.3f}; regular nodes: {regular:.1f} %</source>
   <translation>Jacobien normalisé : pire {worst:.3f}, moyen {mean:.3f} ; nœuds réguliers : {regular:.1f} %</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Côtés</translation>
  </message>
  <message>
   <source>Smooth angle</source>
   <translation>Angle de continuité</translation>
  </message>
  <message>
   <source>Source</source>
   <translation>Source</translation>
  </message>
  <message>
   <source>Source {source} has no rows, {side}: {why}</source>
   <translation>La source {source} n’a pas de rangées, {side} : {why}</translation>
  </message>
  <message>
   <source>Source {source}, pass {pass_} (1:{ratio}): rows {counts}</source>
   <translation>Source {source}, passe {pass_} (1:{ratio}) : rangées {counts}</translation>
  </message>
  <message>
   <source>Stop</source>
   <translation>Arrêter</translation>
  </message>
  <message>
   <source>Stop meshing; the old mesh stays</source>
   <translation>Arrêter le maillage ; l’ancien reste</translation>
  </message>
  <message>
   <source>Stopped. The old mesh was kept.</source>
   <translation>Arrêté. L’ancien maillage est resté.</translation>
  </message>
  <message>
   <source>The triangle mesh that is turned into quads</source>
   <translation>Le maillage de triangles changé en quadrangles</translation>
  </message>
  <message>
   <source>Triangles</source>
   <translation>Triangles</translation>
  </message>
  <message>
   <source>Triangulator</source>
   <translation>Triangles par</translation>
  </message>
  <message>
   <source>Warning: {}</source>
   <translation>Attention : {}</translation>
  </message>
  <message>
   <source>What makes the triangles of the shape; Gmsh takes size and curvature angle of the options</source>
   <translation>Ce qui fait les triangles de la forme ; Gmsh prend la taille et l’angle de courbure des options</translation>
  </message>
  <message>
   <source>Where the triangles are those of a Part shape, the quads can lie on the shape itself: its faces are the patches, its edges the lines of the mesh. Gmsh, where it is installed, makes triangles of good shape in the size that the options ask for, and of a fineness that follows the curvature; OpenCASCADE makes as few as show the shape, which are then remeshed.</source>
   <translation>Si les triangles sont ceux d’une forme Part, les quadrangles peuvent être sur la forme même : ses faces sont les morceaux, ses arêtes les lignes du maillage. Gmsh, s’il est installé, fait des triangles bien formés de la taille que demandent les options, d’une finesse qui suit la courbure ; OpenCASCADE en fait aussi peu qu’il en faut pour montrer la forme, et ils sont ensuite remaillés.</translation>
  </message>
  <message>
   <source>{quads} quads from {triangles} triangles</source>
   <translation>{quads} quadrangles à partir de {triangles} triangles</translation>
  </message>
  <message>
   <source>{quads} quads from {triangles} triangles ({reduction:.1f} % fewer elements)</source>
   <translation>{quads} quadrangles à partir de {triangles} triangles ({reduction:.1f} % d’éléments en moins)</translation>
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
   <translation>Rapport d’aspect</translation>
  </message>
  <message>
   <source>Element</source>
   <translation>Élément</translation>
  </message>
  <message>
   <source>Number of quads (logarithmic) over the measure</source>
   <translation>Nombre de quadrangles (logarithmique) selon la mesure</translation>
  </message>
  <message>
   <source>Quality</source>
   <translation>Qualité</translation>
  </message>
  <message>
   <source>Row</source>
   <translation>Rangée</translation>
  </message>
  <message>
   <source>Scaled Jacobian</source>
   <translation>Jacobien normalisé</translation>
  </message>
  <message>
   <source>Size</source>
   <translation>Taille</translation>
  </message>
  <message>
   <source>Skew</source>
   <translation>Biais</translation>
  </message>
  <message>
   <source>The quads are coloured by the chosen measure: red is bad, blue is good. The scaled Jacobian is 1 for a rectangle and 0 for a quad that is folded flat; thin quads of anisotropic rows keep a good one.</source>
   <translation>Les quadrangles sont colorés selon la mesure choisie : rouge est mauvais, bleu est bon. Le jacobien normalisé vaut 1 pour un rectangle et 0 pour un quadrangle replié ; les quadrangles fins des rangées anisotropes en gardent un bon.</translation>
  </message>
  <message>
   <source>Value</source>
   <translation>Valeur</translation>
  </message>
  <message>
   <source>What the quads are coloured by</source>
   <translation>Ce selon quoi les quadrangles sont colorés</translation>
  </message>
  <message>
   <source>Worst quads; a click zooms to them:</source>
   <translation>Pires quadrangles ; un clic y mène :</translation>
  </message>
  <message>
   <source>matplotlib is not installed: no histogram</source>
   <translation>matplotlib n’est pas installé : pas d’histogramme</translation>
  </message>
  <message>
   <source>{low:.4g} … {high:.4g}, mean {mean:.4g}</source>
   <translation>{low:.4g} … {high:.4g}, moyenne {mean:.4g}</translation>
  </message>
 </context>
 <context>
  <name>Report</name>
  <message>
   <source>Source {source}, {side}, pass {pass_} (1:{ratio}): {rows} rows of {columns} columns; {why}</source>
   <translation>Source {source}, {side}, passe {pass_} (1:{ratio}) : {rows} rangées de {columns} colonnes ; {why}</translation>
  </message>
  <message>
   <source>a boundary, a feature line or another row is too close ahead</source>
   <translation>un bord, une ligne caractéristique ou une autre rangée est trop proche devant</translation>
  </message>
  <message>
   <source>a column has become too slim</source>
   <translation>une colonne est devenue trop étroite</translation>
  </message>
  <message>
   <source>a quad of the row would be too distorted</source>
   <translation>un quadrangle de la rangée serait trop déformé</translation>
  </message>
  <message>
   <source>another row or the boundary lies directly ahead</source>
   <translation>une autre rangée ou le bord se trouve juste devant</translation>
  </message>
  <message>
   <source>as many rows as asked for</source>
   <translation>autant de rangées que demandé</translation>
  </message>
  <message>
   <source>in {} of them the triangles turn too far from one to the next</source>
   <translation>dans {} d’entre elles les triangles tournent trop de l’un au suivant</translation>
  </message>
  <message>
   <source>in {} of them the triangles' size changes too fast</source>
   <translation>dans {} d’entre elles la taille des triangles change trop vite</translation>
  </message>
  <message>
   <source>invalid faces of the shape were taken as they are</source>
   <translation>les faces invalides de la forme ont été prises telles quelles</translation>
  </message>
  <message>
   <source>let Gmsh make them</source>
   <translation>les faire faire par Gmsh</translation>
  </message>
  <message>
   <source>something lies inside the row</source>
   <translation>quelque chose se trouve dans la rangée</translation>
  </message>
  <message>
   <source>the edges of {} triangles were turned because some were thinner than {} of the diagonal</source>
   <translation>les arêtes de {} triangles ont été basculées parce que certains étaient plus minces que {} de la diagonale</translation>
  </message>
  <message>
   <source>the end column reaches a corner of the feature lines</source>
   <translation>la colonne du bout atteint un coin des lignes caractéristiques</translation>
  </message>
  <message>
   <source>the front turns too sharply for one more row</source>
   <translation>le front tourne trop brusquement pour une rangée de plus</translation>
  </message>
  <message>
   <source>the input was repaired</source>
   <translation>l’entrée a été réparée</translation>
  </message>
  <message>
   <source>the line at the row's end turns back to it</source>
   <translation>la ligne au bout de la rangée revient vers elle</translation>
  </message>
  <message>
   <source>the shape's triangles are folded over at {} edges</source>
   <translation>les triangles de la forme sont repliés à {} arêtes</translation>
  </message>
  <message>
   <source>the triangles ahead are too large for the length of the front's edges</source>
   <translation>les triangles devant sont trop grands pour la longueur des arêtes du front</translation>
  </message>
  <message>
   <source>the triangles ahead could not be swapped into the row (column)</source>
   <translation>les triangles devant n’ont pu être basculés pour former la rangée (colonne)</translation>
  </message>
  <message>
   <source>the triangles ahead could not be swapped into the row (top)</source>
   <translation>les triangles devant n’ont pu être basculés pour former la rangée (bord supérieur)</translation>
  </message>
  <message>
   <source>{} edge cut apart</source>
   <translation>{} arête découpée</translation>
  </message>
  <message>
   <source>{} edges cut apart</source>
   <translation>{} arêtes découpées</translation>
  </message>
  <message>
   <source>{} edges were collapsed because they are shorter than {} of the diagonal</source>
   <translation>{} arêtes ont été contractées car elles sont plus courtes que {} de la diagonale</translation>
  </message>
  <message>
   <source>{} facet doubled dropped</source>
   <translation>{} facette en double abandonnée</translation>
  </message>
  <message>
   <source>{} facet turned</source>
   <translation>{} facette retournée</translation>
  </message>
  <message>
   <source>{} facet without all vertices dropped</source>
   <translation>{} facette sans tous ses sommets abandonnée</translation>
  </message>
  <message>
   <source>{} facet without area removed</source>
   <translation>{} facette sans aire enlevée</translation>
  </message>
  <message>
   <source>{} facet without finite coordinates dropped</source>
   <translation>{} facette sans coordonnées finies abandonnée</translation>
  </message>
  <message>
   <source>{} facets doubled dropped</source>
   <translation>{} facettes en double abandonnées</translation>
  </message>
  <message>
   <source>{} facets turned</source>
   <translation>{} facettes retournées</translation>
  </message>
  <message>
   <source>{} facets without all vertices dropped</source>
   <translation>{} facettes sans tous leurs sommets abandonnées</translation>
  </message>
  <message>
   <source>{} facets without area removed</source>
   <translation>{} facettes sans aire enlevées</translation>
  </message>
  <message>
   <source>{} facets without finite coordinates dropped</source>
   <translation>{} facettes sans coordonnées finies abandonnées</translation>
  </message>
  <message>
   <source>{} of them have triangles too long and thin for quads ({} triangles)</source>
   <translation>{} d’entre elles ont des triangles trop longs et fins pour des quadrangles ({} triangles)</translation>
  </message>
  <message>
   <source>{} patches have an odd boundary that nothing can make even</source>
   <translation>{} faces ont un bord au nombre impair d’arêtes que rien ne peut rendre pair</translation>
  </message>
  <message>
   <source>{} patches were remeshed before: {} triangles became {}, edges up to {}</source>
   <translation>{} faces ont été remaillées d’abord : {} triangles sont devenus {}, arêtes jusqu’à {}</translation>
  </message>
  <message>
   <source>{} quads are turned over by the surface to which they were brought</source>
   <translation>{} quadrangles sont retournés par la surface sur laquelle ils ont été mis</translation>
  </message>
  <message>
   <source>{} source nodes could not be merged</source>
   <translation>{} nœuds de la source n’ont pu être fusionnés</translation>
  </message>
  <message>
   <source>{} triangles are left</source>
   <translation>il reste {} triangles</translation>
  </message>
  <message>
   <source>{} vertex added</source>
   <translation>{} sommet ajouté</translation>
  </message>
  <message>
   <source>{} vertex welded</source>
   <translation>{} sommet soudé</translation>
  </message>
  <message>
   <source>{} vertices added</source>
   <translation>{} sommets ajoutés</translation>
  </message>
  <message>
   <source>{} vertices of open edges lie at the place of another one; the surface is not joined there; repair joins it</source>
   <translation>{} sommets d'arêtes ouvertes sont à la place d'un autre; la surface n'y est pas jointe; la réparation la joint</translation>
  </message>
  <message>
   <source>{} vertices welded</source>
   <translation>{} sommets soudés</translation>
  </message>
 </context>
 <context>
  <name>SourcePanel</name>
  <message>
   <source>(closed)</source>
   <translation>(fermée)</translation>
  </message>
  <message>
   <source>1:</source>
   <translation>1:</translation>
  </message>
  <message>
   <source>A source is a line on the triangles along which rows of long, thin quads are built on both sides. Pick it in the view, or choose edges of a Part object. The maximum anisotropy says how many times longer than high the quads at the line become; it falls off with every pass.</source>
   <translation>Une source est une ligne sur les triangles, des deux côtés de laquelle naissent des rangées de quadrangles longs et fins. Elle se choisit dans la vue, ou par des arêtes d’un objet Part. L’anisotropie maximale dit combien de fois plus longs que hauts sont les quadrangles le long de la ligne ; elle diminue à chaque passe.</translation>
  </message>
  <message>
   <source>Anisotropy source</source>
   <translation>Source d’anisotropie</translation>
  </message>
  <message>
   <source>Aspect at the line</source>
   <translation>Aspect le long de la ligne</translation>
  </message>
  <message>
   <source>Click a mesh edge to start, click another to extend the line along ridges and feature lines. Double-click takes the whole line, Ctrl-click cuts it, Esc leaves.</source>
   <translation>Cliquez une arête du maillage pour commencer, une autre pour prolonger la ligne le long des crêtes et lignes caractéristiques. Double-clic prend toute la ligne, Ctrl-clic la coupe, Échap quitte.</translation>
  </message>
  <message>
   <source>How many times longer than high the quads at the line become; 1: a feature line without rows</source>
   <translation>Combien de fois plus longs que hauts deviennent les quadrangles le long de la ligne ; 1 : ligne caractéristique sans rangées</translation>
  </message>
  <message>
   <source>Imprint: make a line that zigzags over the triangles straight before rows start</source>
   <translation>Imprimer : redresser une ligne en zigzag sur les triangles avant les rangées</translation>
  </message>
  <message>
   <source>Length</source>
   <translation>Longueur</translation>
  </message>
  <message>
   <source>Maximum anisotropy</source>
   <translation>Anisotropie maximale</translation>
  </message>
  <message>
   <source>Merge ratio of each pass, with its number of rows or not, e.g. 4:6, 2, 2. Empty: chosen from the maximum anisotropy</source>
   <translation>Rapport de fusion de chaque passe, avec ou sans nombre de rangées, p. ex. 4:6, 2, 2. Vide : d’après l’anisotropie maximale</translation>
  </message>
  <message>
   <source>Mesh edges</source>
   <translation>Arêtes du maillage</translation>
  </message>
  <message>
   <source>Passes</source>
   <translation>Passes</translation>
  </message>
  <message>
   <source>Pick a line first</source>
   <translation>Choisissez d’abord une ligne</translation>
  </message>
  <message>
   <source>Pick in the view</source>
   <translation>Choisir dans la vue</translation>
  </message>
  <message>
   <source>Sides</source>
   <translation>Côtés</translation>
  </message>
  <message>
   <source>Sides of the line, seen along it with the surface's normal up, that get rows</source>
   <translation>Côtés de la ligne, vue dans sa direction, normale vers le haut, qui reçoivent des rangées</translation>
  </message>
  <message>
   <source>Straighten zigzags</source>
   <translation>Redresser les zigzags</translation>
  </message>
  <message>
   <source>automatic</source>
   <translation>automatique</translation>
  </message>
  <message>
   <source>both</source>
   <translation>les deux</translation>
  </message>
  <message>
   <source>left</source>
   <translation>gauche</translation>
  </message>
  <message>
   <source>right</source>
   <translation>droite</translation>
  </message>
 </context>
 <context>
  <name>Stages</name>
  <message>
   <source>Building rows</source>
   <translation>Rangées</translation>
  </message>
  <message>
   <source>Checking</source>
   <translation>Vérification</translation>
  </message>
  <message>
   <source>Cleaning up</source>
   <translation>Nettoyage</translation>
  </message>
  <message>
   <source>Evening out patches</source>
   <translation>Équilibrage des morceaux</translation>
  </message>
  <message>
   <source>Filling with quads</source>
   <translation>Remplissage</translation>
  </message>
  <message>
   <source>Finding features</source>
   <translation>Lignes caractéristiques</translation>
  </message>
  <message>
   <source>Measuring</source>
   <translation>Mesure</translation>
  </message>
  <message>
   <source>Preparing triangles</source>
   <translation>Préparation des triangles</translation>
  </message>
  <message>
   <source>Repairing</source>
   <translation>Réparation</translation>
  </message>
  <message>
   <source>Smoothing</source>
   <translation>Lissage</translation>
  </message>
  <message>
   <source>Triangulating</source>
   <translation>Triangulation</translation>
  </message>
  <message>
   <source>{stage} {percent} % – Esc stops it</source>
   <translation>{stage} {percent} % – Échap l’arrête</translation>
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
   <translation>Ligne {index} : {length}, {edges} arêtes</translation>
  </message>
  <message>
   <source>Long, smooth ridges of the surface. OK makes a source of each that is ticked.</source>
   <translation>Crêtes longues et lisses de la surface. OK fait une source de chacune qui est cochée.</translation>
  </message>
  <message>
   <source>Maximum anisotropy</source>
   <translation>Anisotropie maximale</translation>
  </message>
  <message>
   <source>No long, smooth ridge was found. Pick the line in the view instead.</source>
   <translation>Aucune crête longue et lisse. Choisissez plutôt la ligne dans la vue.</translation>
  </message>
  <message>
   <source>Ridges of curvature and sharp edges that are long and smooth look like leading and trailing edges. Tick those that shall become sources.</source>
   <translation>Les crêtes de courbure et arêtes vives longues et lisses ressemblent à des bords d’attaque et de fuite. Cochez celles qui doivent devenir des sources.</translation>
  </message>
  <message>
   <source>Suggested sources</source>
   <translation>Sources proposées</translation>
  </message>
 </context>
</TS>
