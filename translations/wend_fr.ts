<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>CheatSheet</name>
    <message>
        <source>Pointer</source>
        <translation>Pointeur</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Clic</translation>
    </message>
    <message>
        <source>sets a pin</source>
        <translation>pose une épingle</translation>
    </message>
    <message>
        <source>Drag a pin</source>
        <translation>Tirer une épingle</translation>
    </message>
    <message>
        <source>moves it; Esc puts it back</source>
        <translation>la déplace&#x202f;; Échap la remet en place</translation>
    </message>
    <message>
        <source>Shift-click</source>
        <translation>Maj+clic</translation>
    </message>
    <message>
        <source>selects several pins</source>
        <translation>sélectionne plusieurs épingles</translation>
    </message>
    <message>
        <source>Digits while dragging</source>
        <translation>Chiffres pendant le geste</translation>
    </message>
    <message>
        <source>set the number; Enter confirms it</source>
        <translation>donnent la valeur, Entrée la valide</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>zooms to the pointer</source>
        <translation>zoome vers le pointeur</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ et ]</translation>
    </message>
    <message>
        <source>size of a brush</source>
        <translation>taille du pinceau</translation>
    </message>
    <message>
        <source>Hold H</source>
        <translation>Maintenir H</translation>
    </message>
    <message>
        <source>Hold \</source>
        <translation>Maintenir \</translation>
    </message>
    <message>
        <source>shows the shape before it was bent</source>
        <translation>montre la forme avant déformation</translation>
    </message>
    <message>
        <source>X, Y, Z while dragging</source>
        <translation>X, Y, Z pendant le geste</translation>
    </message>
    <message>
        <source>lock an axis</source>
        <translation>verrouillent un axe</translation>
    </message>
    <message>
        <source>Right or middle button</source>
        <translation>Bouton droit ou central</translation>
    </message>
    <message>
        <source>turns the view; with Shift, moves it</source>
        <translation>tourne la vue&#x202f;; avec Maj, la déplace</translation>
    </message>
    <message>
        <source>Middle click</source>
        <translation>Clic central</translation>
    </message>
    <message>
        <source>sets the point to turn around</source>
        <translation>fixe le point autour duquel tourner</translation>
    </message>
    <message>
        <source>widens it to a circle</source>
        <translation>l’élargit en cercle</translation>
    </message>
    <message>
        <source>Drag the ring&apos;s dot or square</source>
        <translation>Tirer le point ou le carré de l’anneau</translation>
    </message>
    <message>
        <source>rotates or scales; Shift snaps to 15°</source>
        <translation>fait pivoter ou met à l’échelle&#x202f;; Maj par pas de 15°</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>nudge by a pixel, with Shift by ten</source>
        <translation>décalent d’un pixel, avec Maj de dix</translation>
    </message>
    <message>
        <source>pans</source>
        <translation>déplace la vue</translation>
    </message>
    <message>
        <source>Shift-click with the brush</source>
        <translation>Maj-clic avec le pinceau</translation>
    </message>
    <message>
        <source>paints a straight line</source>
        <translation>peint une ligne droite</translation>
    </message>
    <message>
        <source>Arrow keys without a pin</source>
        <translation>Touches fléchées sans épingle</translation>
    </message>
    <message>
        <source>move a cross, Enter clicks there</source>
        <translation>déplacent une croix, Entrée clique à cet endroit</translation>
    </message>
    <message>
        <source>Alt-right-drag a brush</source>
        <translation>Alt-glisser droit avec le pinceau</translation>
    </message>
    <message>
        <source>changes its size and hardness</source>
        <translation>change sa taille et sa dureté</translation>
    </message>
    <message>
        <source>Tap the space bar</source>
        <translation>Taper sur la barre d’espace</translation>
    </message>
    <message>
        <source>plays or pauses; held, it moves the view</source>
        <translation>lit ou met en pause&#x202f;; maintenue, elle déplace la vue</translation>
    </message>
    <message>
        <source>Middle button</source>
        <translation>Bouton du milieu</translation>
    </message>
    <message>
        <source>hides pins and overlays</source>
        <translation>masque épingles et incrustations</translation>
    </message>
    <message>
        <source>Ctrl+Shift-drag a pin</source>
        <translation>Ctrl+Maj + glisser une épingle</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistes</translation>
    </message>
    <message>
        <source>Up, Down</source>
        <translation>Haut, Bas</translation>
    </message>
    <message>
        <source>choose a pin</source>
        <translation>choisissent une épingle</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Gauche, Droite</translation>
    </message>
    <message>
        <source>show another time</source>
        <translation>montrent un autre instant</translation>
    </message>
    <message>
        <source>Alt+Left, Alt+Right</source>
        <translation>Alt+Gauche, Alt+Droite</translation>
    </message>
    <message>
        <source>move the chosen bars or keys</source>
        <translation>déplacent les barres ou les clés choisies</translation>
    </message>
    <message>
        <source>Shift-click, or a frame</source>
        <translation>Maj+clic, ou un cadre</translation>
    </message>
    <message>
        <source>chooses several</source>
        <translation>en choisit plusieurs</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>opens their easing curve</source>
        <translation>ouvre leur courbe de lissage</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+V</source>
        <translation>Ctrl+C, Ctrl+V</translation>
    </message>
    <message>
        <source>copy keys, paste them at the time shown</source>
        <translation>copient des clés et les collent à l’instant montré</translation>
    </message>
    <message>
        <source>Ctrl+Shift+V</source>
        <translation>Ctrl+Maj+V</translation>
    </message>
    <message>
        <source>pastes them mirrored</source>
        <translation>les colle en miroir</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>removes them</source>
        <translation>les supprime</translation>
    </message>
    <message>
        <source>I, O</source>
        <translation>I, O</translation>
    </message>
    <message>
        <source>begin and end the cycle here</source>
        <translation>commencent et terminent ici le cycle</translation>
    </message>
    <message>
        <source>Shift-drag the numbers</source>
        <translation>Glisser les chiffres avec Maj</translation>
    </message>
    <message>
        <source>marks the cycle</source>
        <translation>marque le cycle</translation>
    </message>
    <message>
        <source>Shift+M</source>
        <translation>Maj+M</translation>
    </message>
    <message>
        <source>adds a marker</source>
        <translation>ajoute un repère</translation>
    </message>
</context>
<context>
    <name>Core</name>
    <message>
        <source>at time %1 %2 cannot go on: %3</source>
        <translation>au temps %1, %2 ne peut pas continuer&#x202f;: %3</translation>
    </message>
    <message>
        <source>at time %1 the shape is too stiff to settle further near %2: the steps would be too short; allow a larger tolerance</source>
        <translation>au temps %1, la forme est trop raide près de %2 pour se reposer davantage&#x202f;: les pas seraient trop courts&#x202f;; autorisez une plus grande tolérance</translation>
    </message>
    <message>
        <source>the shape would fold over near %1, in cell %2; move it less far or along another path, or release what holds the shape there</source>
        <translation>la forme se replierait près de %1, dans la cellule %2&#x202f;; allez moins loin ou autrement, ou libérez ce qui la tient là</translation>
    </message>
    <message>
        <source>the shape would fold over near %1; move it less far or along another path, or release what holds the shape there</source>
        <translation>la forme se replierait près de %1&#x202f;; allez moins loin ou autrement, ou libérez ce qui la tient là</translation>
    </message>
    <message>
        <source>it moves too fast near %1: the steps would be too short; give its motion more time, or allow a larger tolerance</source>
        <translation>c’est trop rapide près de %1, les pas seraient trop courts&#x202f;; donnez plus de temps au mouvement ou autorisez une plus grande tolérance</translation>
    </message>
    <message>
        <source>the shape near %1 is stretched or squeezed so much that no velocity can be computed; move it less far, or make the material or the mesh more even there</source>
        <translation>la forme est si étirée ou comprimée près de %1 qu’aucune vitesse ne peut être calculée&#x202f;; allez moins loin, ou rendez le matériau ou le maillage plus réguliers à cet endroit</translation>
    </message>
    <message>
        <source>it moves so fast near %1 that numbers overflow; move it less far, or give its motion more time</source>
        <translation>c’est si rapide près de %1 que les nombres débordent&#x202f;; allez moins loin ou donnez plus de temps au mouvement</translation>
    </message>
    <message>
        <source>the shape needs about %1 of memory; %2 are free; fewer vertices need less</source>
        <translation>la forme demande environ %1 de mémoire ; %2 sont libres ; moins de sommets en demandent moins</translation>
    </message>
    <message>
        <source>%1 and %2 move the point %3 in different ways at time %4</source>
        <translation>%1 et %2 déplacent différemment le point %3 au temps %4</translation>
    </message>
    <message>
        <source>handle &quot;%1&quot;</source>
        <translation>l’épingle «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>handle %1</source>
        <translation>l’épingle %1</translation>
    </message>
    <message>
        <source>the shape</source>
        <translation>la forme</translation>
    </message>
    <message>
        <source>its region holds no vertex</source>
        <translation>sa région ne contient aucun sommet</translation>
    </message>
    <message>
        <source>vertex %1 belongs to no cell</source>
        <translation>le sommet %1 n’appartient à aucune cellule</translation>
    </message>
    <message>
        <source>the picture has no alpha channel to take an outline from</source>
        <translation>l’image n’a pas de canal alpha d’où tirer un contour</translation>
    </message>
    <message>
        <source>the picture has no pixels</source>
        <translation>l’image n’a pas de pixels</translation>
    </message>
    <message>
        <source>no part of the picture is as large as %1 pixels</source>
        <translation>aucune partie de l’image n’atteint %1 pixels</translation>
    </message>
    <message>
        <source>the picture is fully transparent</source>
        <translation>l’image est entièrement transparente</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha is nowhere above the threshold of %1 %</source>
        <translation>l’alpha de l’image ne dépasse nulle part le seuil de %1 %</translation>
    </message>
    <message>
        <source>the picture&apos;s alpha has too many contours: it looks like noise</source>
        <translation>l’alpha de l’image a trop de contours&#x202f;: on dirait du bruit</translation>
    </message>
    <message>
        <source>the outline is empty</source>
        <translation>le contour est vide</translation>
    </message>
    <message>
        <source>the outline crosses or overlaps itself near %1</source>
        <translation>le contour se croise ou se recouvre près de %1</translation>
    </message>
    <message>
        <source>the outline cannot be triangulated (%1)</source>
        <translation>le contour ne peut pas être triangulé (%1)</translation>
    </message>
    <message>
        <source>points %1 and %2 are the same, %3</source>
        <translation>les points %1 et %2 sont identiques, %3</translation>
    </message>
    <message>
        <source>point %1, %2, is outside the shape</source>
        <translation>le point %1, %2, est hors de la forme</translation>
    </message>
    <message>
        <source>an edge length of %1 would take more than %2 vertices</source>
        <translation>une longueur d’arête de %1 demanderait plus de %2 sommets</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>est vide</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>n’existe pas</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>est un dossier</translation>
    </message>
    <message>
        <source>is a pipe, not a file</source>
        <translation>est un tube, pas un fichier</translation>
    </message>
    <message>
        <source>is a device, not a file</source>
        <translation>est un périphérique, pas un fichier</translation>
    </message>
    <message>
        <source>is a symbolic link that leads back to itself</source>
        <translation>est un lien symbolique qui revient à lui-même</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>ne peut pas être lu&#x202f;: %1</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>ne peut pas être écrit&#x202f;: %1</translation>
    </message>
    <message>
        <source>the disk may be full</source>
        <translation>le disque est peut-être plein</translation>
    </message>
    <message>
        <source>the disk is full, only %1 are free</source>
        <translation>le disque est plein, il ne reste que %1</translation>
    </message>
    <message>
        <source>the folder %1 does not exist</source>
        <translation>le dossier %1 n’existe pas</translation>
    </message>
    <message>
        <source>the folder %1 is not writable</source>
        <translation>le dossier %1 n’est pas accessible en écriture</translation>
    </message>
    <message>
        <source>is read-only: make it writable first, or choose another name</source>
        <translation>est en lecture seule&#x202f;: rendez-le d’abord modifiable, ou choisissez un autre nom</translation>
    </message>
    <message>
        <source>is a model or a mesh of a kind that is not read (%1); these are: %2</source>
        <translation>est un modèle ou un maillage d’un type qui n’est pas lu (%1) ; sont lus : %2</translation>
    </message>
    <message>
        <source>a JPEG XL picture</source>
        <translation>une image JPEG XL</translation>
    </message>
    <message>
        <source>a GIMP picture (XCF; export it from GIMP as PNG or OpenRaster)</source>
        <translation>une image GIMP (XCF ; l’exporter depuis GIMP en PNG ou OpenRaster)</translation>
    </message>
    <message>
        <source>has a layer &quot;%1&quot; with an opacity out of range: it is limited to 0 … 100 %</source>
        <translation>a un calque « %1 » dont l’opacité est impossible : elle est limitée à 0 … 100 %</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>a film</source>
        <translation>un film</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>une archive ZIP</translation>
    </message>
    <message>
        <source>a text file</source>
        <translation>un fichier texte</translation>
    </message>
    <message>
        <source>not a picture that Wend knows</source>
        <translation>une image que Wend ne connaît pas</translation>
    </message>
    <message>
        <source>cannot be read as a picture: %1</source>
        <translation>ne peut pas être lu comme image&#x202f;: %1</translation>
    </message>
    <message>
        <source>has no pixels</source>
        <translation>n’a pas de pixels</translation>
    </message>
    <message>
        <source>is a volume, not a picture</source>
        <translation>est un volume, pas une image</translation>
    </message>
    <message>
        <source>has %1 x %2 pixels, more than %3 million</source>
        <translation>a %1 × %2 pixels, plus de %3 millions</translation>
    </message>
    <message>
        <source>is truncated or corrupt</source>
        <translation>est tronqué ou endommagé</translation>
    </message>
    <message>
        <source>is transparent everywhere</source>
        <translation>est transparent partout</translation>
    </message>
    <message>
        <source>holds tetrahedra, but the project is in the plane</source>
        <translation>contient des tétraèdres, mais le projet est dans le plan</translation>
    </message>
    <message>
        <source>holds no tetrahedra, but the project is in space</source>
        <translation>ne contient pas de tétraèdres, mais le projet est dans l’espace</translation>
    </message>
    <message>
        <source>the surface has no triangle</source>
        <translation>la surface n’a pas de triangle</translation>
    </message>
    <message>
        <source>the surface has no extent</source>
        <translation>la surface n’a pas d’étendue</translation>
    </message>
    <message>
        <source>the surface encloses no volume</source>
        <translation>la surface n’enferme aucun volume</translation>
    </message>
    <message>
        <source>the surface bounds no volume: %1</source>
        <translation>la surface ne délimite aucun volume&#x202f;: %1</translation>
    </message>
    <message>
        <source>the surface intersects itself</source>
        <translation>la surface se coupe elle-même</translation>
    </message>
    <message>
        <source>the surface has features too small for its size</source>
        <translation>la surface a des détails trop fins pour sa taille</translation>
    </message>
    <message>
        <source>two facets of the surface lie almost on each other</source>
        <translation>deux facettes de la surface sont presque confondues</translation>
    </message>
    <message>
        <source>the volume mesher ran out of memory</source>
        <translation>le mailleur de volume manque de mémoire</translation>
    </message>
    <message>
        <source>the volume mesher did not finish within %1 s of computing; a coarser quality or a larger maxVolume may help</source>
        <translation>le mailleur de volume n’a pas fini en %1 s de calcul&#x202f;; une qualité plus grossière ou de plus grands tétraèdres peuvent aider</translation>
    </message>
    <message>
        <source>all points lie in one plane</source>
        <translation>tous les points sont dans un plan</translation>
    </message>
    <message>
        <source>%1 open edge (first: %2)</source>
        <translation>%1 arête ouverte (%2)</translation>
    </message>
    <message>
        <source>%1 open edges (first: %2)</source>
        <translation>%1 arêtes ouvertes (d’abord %2)</translation>
    </message>
    <message>
        <source>%1 edge of more than two triangles (first: %2)</source>
        <translation>%1 arête de plus de deux triangles (%2)</translation>
    </message>
    <message>
        <source>%1 edges of more than two triangles (first: %2)</source>
        <translation>%1 arêtes de plus de deux triangles (d’abord %2)</translation>
    </message>
    <message>
        <source>%1 pair of triangles that intersect (first: %2)</source>
        <translation>%1 paire de triangles qui se coupent (%2)</translation>
    </message>
    <message>
        <source>%1 pairs of triangles that intersect (first: %2)</source>
        <translation>%1 paires de triangles qui se coupent (d’abord %2)</translation>
    </message>
    <message>
        <source>%1 triangle without area (first: %2)</source>
        <translation>%1 triangle sans aire (%2)</translation>
    </message>
    <message>
        <source>%1 triangles without area (first: %2)</source>
        <translation>%1 triangles sans aire (d’abord %2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangle (first: %2)</source>
        <translation>%1 triangle en double (%2)</translation>
    </message>
    <message>
        <source>%1 duplicate triangles (first: %2)</source>
        <translation>%1 triangles en double (d’abord %2)</translation>
    </message>
    <message>
        <source>%1 edge where the orientation changes (first: %2)</source>
        <translation>%1 arête où l’orientation change (%2)</translation>
    </message>
    <message>
        <source>%1 edges where the orientation changes (first: %2)</source>
        <translation>%1 arêtes où l’orientation change (d’abord %2)</translation>
    </message>
    <message>
        <source>the surface was repaired: %1</source>
        <translation>la surface a été réparée&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 coincident vertex merged</source>
        <translation>%1 sommet confondu fusionné</translation>
    </message>
    <message>
        <source>%1 coincident vertices merged</source>
        <translation>%1 sommets confondus fusionnés</translation>
    </message>
    <message>
        <source>%1 triangle without area dropped</source>
        <translation>%1 triangle sans aire supprimé</translation>
    </message>
    <message>
        <source>%1 triangles without area dropped</source>
        <translation>%1 triangles sans aire supprimés</translation>
    </message>
    <message>
        <source>%1 duplicate triangle dropped</source>
        <translation>%1 triangle en double supprimé</translation>
    </message>
    <message>
        <source>%1 duplicate triangles dropped</source>
        <translation>%1 triangles en double supprimés</translation>
    </message>
    <message>
        <source>%1 triangle turned over</source>
        <translation>%1 triangle retourné</translation>
    </message>
    <message>
        <source>%1 triangles turned over</source>
        <translation>%1 triangles retournés</translation>
    </message>
    <message>
        <source>%1 hole filled</source>
        <translation>%1 trou comblé</translation>
    </message>
    <message>
        <source>%1 holes filled</source>
        <translation>%1 trous comblés</translation>
    </message>
    <message>
        <source>the surface is embedded in a cage of %1 vertices, since %2</source>
        <translation>la surface est incluse dans une cage de %1 sommets, car %2</translation>
    </message>
    <message>
        <source>it cannot be meshed as it is: %1</source>
        <translation>elle ne peut pas être maillée telle quelle&#x202f;: %1</translation>
    </message>
    <message>
        <source>it has %1 vertices, where %2 were aimed at</source>
        <translation>elle a %1 sommets, alors que %2 étaient visés</translation>
    </message>
    <message>
        <source>the cage has %1 vertices, where %2 were aimed at: whole cubes allow nothing nearer</source>
        <translation>la cage a %1 sommets, alors que %2 étaient visés&#x202f;: des cubes entiers ne permettent pas mieux</translation>
    </message>
    <message>
        <source>the cells of the cage are larger than asked for: there is no memory for smaller ones</source>
        <translation>les cellules de la cage sont plus grandes que demandé&#x202f;: la mémoire ne suffit pas pour de plus petites</translation>
    </message>
    <message>
        <source>sizes are for the exact surface: a cage has cells of one size</source>
        <translation>les tailles valent pour la surface exacte&#x202f;: une cage a des cellules d’une seule taille</translation>
    </message>
    <message>
        <source>its %1 parts share cells of the cage and move together as %2: smaller cells keep more of them apart</source>
        <translation>ses %1 parties partagent des cellules de la cage et bougent ensemble comme %2&#x202f;: de plus petites cellules en séparent davantage</translation>
    </message>
    <message>
        <source>the cage consists of %1 bodies that are not connected: each needs a handle of its own to follow</source>
        <translation>la cage est en %1 corps qui ne tiennent pas ensemble&#x202f;: chacun a besoin de sa propre épingle pour suivre</translation>
    </message>
    <message>
        <source>%1 of %2 vertices lie outside the solid that carries them</source>
        <translation>%1 sommets sur %2 sont hors du solide qui les porte</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the quality asked for needs them</source>
        <translation>le maillage a %1 sommets, alors que %2 étaient visés&#x202f;: la qualité demandée les exige</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: the surface is kept as it is</source>
        <translation>le maillage a %1 sommets, alors que %2 étaient visés&#x202f;: la surface est gardée telle quelle</translation>
    </message>
    <message>
        <source>the surface&apos;s triangles are far larger than the cells inside and are kept as they are, which makes uneven cells</source>
        <translation>les triangles de la surface sont bien plus grands que les cellules intérieures et restent tels quels, ce qui donne des cellules inégales</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cell is above it)</source>
        <translation>la pire cellule a un rapport rayon/arête de %1, alors que %2 était demandé (%3 cellule au-dessus)</translation>
    </message>
    <message>
        <source>the worst cell has a ratio of radius to edge of %1, where %2 was asked for (%3 cells are above it)</source>
        <translation>la pire cellule a un rapport rayon/arête de %1, alors que %2 était demandé (%3 cellules au-dessus)</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2</source>
        <translation>%1&#x202f;: la surface est gardée telle quelle et l’impose, à ses triangles %2</translation>
    </message>
    <message>
        <source>%1 vertices of the surface belong to no tetrahedron: meshes of tetrahedra are written without them, so that later vertices have other numbers</source>
        <translation>%1 sommets de la surface n’appartiennent à aucun tétraèdre&#x202f;: les maillages de tétraèdres sont écrits sans eux, donc avec d’autres numéros ensuite</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 sommets n’appartiennent à aucune cellule. Ils restent dans ce qui est écrit&#x202f;: certains solveurs veulent qu’on les retire d’abord</translation>
    </message>
    <message>
        <source>parts that touch vertex to vertex are connected: %1 vertices move with others at the same place</source>
        <translation>les parties qui se touchent sommet à sommet tiennent ensemble&#x202f;: %1 sommets bougent avec d’autres au même endroit</translation>
    </message>
    <message>
        <source>a part of %1 hangs only on %2 near %3: what turns freely there may be flung far away unless handles hold it</source>
        <translation>une partie de %1 ne tient qu’à %2 près de %3&#x202f;: ce qui y tourne librement peut être projeté au loin, sauf si des épingles le tiennent</translation>
    </message>
    <message>
        <source>%1 parts hang only on a vertex or an edge, the first, of %2, on %3 near %4: what turns freely there may be flung far away unless handles hold it</source>
        <translation>%1 parties ne tiennent qu’à un sommet ou une arête, la première, de %2, à %3 près de %4&#x202f;: ce qui y tourne librement peut être projeté au loin, sauf si des épingles le tiennent</translation>
    </message>
    <message>
        <source>%1 cells</source>
        <translation>%1 cellules</translation>
    </message>
    <message>
        <source>%1 cell</source>
        <translation>%1 cellule</translation>
    </message>
    <message>
        <source>vertex %1</source>
        <translation>le sommet %1</translation>
    </message>
    <message>
        <source>the edge %1</source>
        <translation>l’arête %1</translation>
    </message>
    <message>
        <source>%1 single step</source>
        <translation>%1 étape isolée</translation>
    </message>
    <message>
        <source>%1 single steps</source>
        <translation>%1 étapes isolées</translation>
    </message>
    <message>
        <source>there is no triangle %1</source>
        <translation>il n’y a pas de triangle %1</translation>
    </message>
    <message>
        <source>no hole has the edge %1</source>
        <translation>aucun trou n’a l’arête %1</translation>
    </message>
    <message>
        <source>the cage closes a gap within one part, %1 wide near %2: what lies on both sides moves together</source>
        <translation>la cage ferme un interstice dans une même partie, large de %1 près de %2&#x202f;: ce qui est de part et d’autre bouge ensemble</translation>
    </message>
    <message>
        <source>the cage closes %1 gaps within one part, the narrowest %2 wide near %3: what lies on both sides moves together</source>
        <translation>la cage ferme %1 interstices dans une même partie, le plus étroit large de %2 près de %3&#x202f;: ce qui est de part et d’autre bouge ensemble</translation>
    </message>
    <message>
        <source>%1; about %2 vertices open the widest</source>
        <translation>%1&#x202f;; environ %2 sommets ouvrent le plus large</translation>
    </message>
    <message>
        <source>%1; cells of at most %2 open the widest</source>
        <translation>%1&#x202f;; des cellules d’au plus %2 ouvrent le plus large</translation>
    </message>
    <message>
        <source>%1; a detail of %2 opens the widest</source>
        <translation>%1&#x202f;; une finesse de %2 ouvre le plus large</translation>
    </message>
    <message>
        <source>1 vertex of the surface belongs to no tetrahedron: meshes of tetrahedra are written without it, so that later vertices have other numbers</source>
        <translation>1 sommet de la surface n&apos;appartient à aucun tétraèdre&#x202f;: les maillages de tétraèdres sont écrits sans lui, donc avec d&apos;autres numéros ensuite</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 sommet n&apos;appartient à aucune cellule. Il reste dans ce qui est écrit&#x202f;: certains solveurs veulent qu&apos;on l&apos;ôte d&apos;abord</translation>
    </message>
    <message>
        <source>holds %1 points, but neither triangles nor tetrahedra between them: a surface has to be made of the points first, as MeshLab and CloudCompare do</source>
        <translation>contient %1 points, mais ni triangles ni tétraèdres entre eux&#x202f;: il faut d’abord faire une surface de ces points, avec MeshLab ou CloudCompare par exemple</translation>
    </message>
    <message>
        <source>%1: its points have four coordinates; only points in space, which have three, are read</source>
        <translation>%1&#x202f;: ses points ont quatre coordonnées&#x202f;; seuls les points de l’espace, qui en ont trois, sont lus</translation>
    </message>
    <message>
        <source>the cage mesher did not finish within %1 s of computing; fewer vertices or larger cells may help</source>
        <translation>la cage n’était pas finie après %1 s de calcul&#x202f;; moins de sommets ou de plus grandes cellules peuvent aider</translation>
    </message>
    <message>
        <source>there is no memory for a cage of so many cells; fewer vertices or larger cells may help</source>
        <translation>la mémoire ne suffit pas pour une cage d’autant de cellules&#x202f;; moins de sommets ou de plus grandes cellules peuvent aider</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and about %3 vertices open the widest</source>
        <translation>%1&#x202f;; une finesse de %2 et environ %3 sommets ouvrent le plus large</translation>
    </message>
    <message>
        <source>%1; a detail of %2 and cells of at most %3 open the widest</source>
        <translation>%1&#x202f;; une finesse de %2 et des cellules d’au plus %3 ouvrent le plus large</translation>
    </message>
    <message>
        <source>a list of points without a surface</source>
        <translation>une liste de points sans surface</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices, where %2 were aimed at: its outline needs them</source>
        <translation>le maillage a %1 sommets, alors que %2 étaient visés&#x202f;: son contour en a besoin</translation>
    </message>
    <message>
        <source>is no project of Wend, which is JSON and begins with {</source>
        <translation>n’est pas un projet de Wend, qui est du JSON et commence par {</translation>
    </message>
    <message>
        <source>has %1 pictures (pages, frames or parts): the first one is read</source>
        <translation>contient %1 images (pages, vues ou parties) : la première est lue</translation>
    </message>
    <message>
        <source>has channels that are left out: %1</source>
        <translation>a des canaux qui sont ignorés : %1</translation>
    </message>
    <message>
        <source>has a channel of no declared kind after its colours: it is taken as alpha</source>
        <translation>a après ses couleurs un canal de nature non déclarée : il est pris pour l’alpha</translation>
    </message>
    <message>
        <source>reaches beyond its display window of %1 x %2 pixels: what lies outside is cut off</source>
        <translation>dépasse sa fenêtre d’affichage de %1 x %2 pixels : ce qui est dehors est coupé</translation>
    </message>
    <message>
        <source>has a colour profile that does not fit its colours: it is left out</source>
        <translation>a un profil de couleur qui ne convient pas à ses couleurs : il est ignoré</translation>
    </message>
    <message>
        <source>has a colour space that is not known (cICP %1): it is not kept</source>
        <translation>a un espace colorimétrique inconnu (cICP %1) : il n’est pas conservé</translation>
    </message>
    <message>
        <source>1 pixel is not a finite number (NaN or infinity), at x %1, y %2</source>
        <translation>1 pixel n’est pas un nombre fini (NaN ou infini), en x %1, y %2</translation>
    </message>
    <message>
        <source>%1 pixels are not finite numbers (NaN or infinity), the first at x %2, y %3</source>
        <translation>%1 pixels ne sont pas des nombres finis (NaN ou infini), le premier en x %2, y %3</translation>
    </message>
    <message>
        <source>is %1. Wend opens PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, camera raw and other pictures</source>
        <translation>est %1. Wend ouvre PNG, JPEG, TIFF, EXR, WebP, GIF, PSD, OpenRaster, Krita, SVG, HEIC, AVIF, JPEG 2000, RAW d’appareil photo et d’autres images</translation>
    </message>
    <message>
        <source>its reader failed inside (signal %1)</source>
        <translation>le lecteur a planté (signal %1)</translation>
    </message>
    <message>
        <source>its reader was ended (signal %1)</source>
        <translation>le lecteur a été arrêté (signal %1)</translation>
    </message>
    <message>
        <source>its reader failed (exit code %1)</source>
        <translation>le lecteur a échoué (code de sortie %1)</translation>
    </message>
    <message>
        <source>its reader has done nothing for %1 s</source>
        <translation>le lecteur n’a rien fait pendant %1 s</translation>
    </message>
    <message>
        <source>its reader has not come to an end</source>
        <translation>le lecteur n’est pas arrivé au bout</translation>
    </message>
    <message>
        <source>it needs more than the %1 MB of memory that reading may take</source>
        <translation>il faut plus que les %1 Mo de mémoire permis à la lecture</translation>
    </message>
    <message>
        <source>has %1 layers: opened flattened</source>
        <translation>a %1 calques : ouvert aplati</translation>
    </message>
    <message>
        <source>holds no picture of all its layers (%1): save it with one</source>
        <translation>ne contient pas d’image de tous ses calques (%1) : l’enregistrer avec une</translation>
    </message>
    <message>
        <source>has a damaged %1</source>
        <translation>a un fichier %1 endommagé</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and %3 times more</source>
        <translation>au temps %1 la forme saute vers un autre équilibre près de %2, et %3 fois encore</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2</source>
        <translation>au temps %1 la forme saute vers un autre équilibre près de %2</translation>
    </message>
    <message>
        <source>pins of the other project without a namesake here, placed in proportion: %1</source>
        <translation>épingles de l’autre projet sans homonyme ici, placées en proportion : %1</translation>
    </message>
    <message>
        <source>pins of the other project that find no place here and are left out: %1</source>
        <translation>épingles de l’autre projet qui ne trouvent pas de place ici et sont omises : %1</translation>
    </message>
    <message>
        <source>pins without a motion in the other project, which hold still: %1</source>
        <translation>épingles sans mouvement dans l’autre projet, qui restent immobiles : %1</translation>
    </message>
    <message>
        <source>moves a solid: its motion does not fit a picture</source>
        <translation>bouge un solide : son mouvement ne convient pas à une image</translation>
    </message>
    <message>
        <source>moves a picture: its motion does not fit a solid</source>
        <translation>bouge une image : son mouvement ne convient pas à un solide</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep; spaces filled: %2, hollow: %3</source>
        <translation>des coques sont emboîtées, jusqu’à %1 niveaux ; espaces pleins : %2, creux : %3</translation>
    </message>
    <message>
        <source>shells lie one in the other, up to %1 deep, and bodies touch along shared walls; spaces filled: %2, hollow: %3</source>
        <translation>des coques sont emboîtées, jusqu’à %1 niveaux, et des corps se touchent par des parois communes ; espaces pleins : %2, creux : %3</translation>
    </message>
    <message>
        <source>bodies touch along shared walls; spaces filled: %1, hollow: %2</source>
        <translation>des corps se touchent par des parois communes ; espaces pleins : %1, creux : %2</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths are scaled</source>
        <translation>%1 a %2 × %3 pixels, et le projet a été fait pour %4 × %5 : épingles et trajectoires sont mises à l’échelle</translation>
    </message>
    <message>
        <source>%1 has %2 × %3 pixels, and the project was made for %4 × %5: pins and paths stay where they are</source>
        <translation>%1 a %2 × %3 pixels, et le projet a été fait pour %4 × %5 : épingles et trajectoires restent où elles sont</translation>
    </message>
    <message>
        <source>the project&apos;s picture is no SVG drawing: it has no paths that could be written</source>
        <translation>l’image du projet n’est pas un dessin SVG : elle n’a pas de tracés à écrire</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is no SVG drawing: it becomes a picture in the SVG file</source>
        <translation>la partie « %1 » n’est pas un dessin SVG : elle devient une image dans le fichier SVG</translation>
    </message>
    <message>
        <source>the part &quot;%1&quot; is cut: it becomes a picture in the SVG file</source>
        <translation>la partie « %1 » est découpée : elle devient une image dans le fichier SVG</translation>
    </message>
    <message>
        <source>its pattern &quot;%1&quot; turns and stretches with each shape, but is not bent</source>
        <translation>son motif « %1 » tourne et s’étire avec chaque forme, mais n’est pas déformé</translation>
    </message>
    <message>
        <source>a picture in it stays one</source>
        <translation>une image qu’il contient reste une image</translation>
    </message>
    <message>
        <source>its picture &quot;%1&quot; is not in the file: it is left out</source>
        <translation>son image « %1 » n’est pas dans le fichier : elle est omise</translation>
    </message>
    <message>
        <source>its text along a path is left out</source>
        <translation>son texte le long d’un tracé est omis</translation>
    </message>
    <message>
        <source>its &lt;%1&gt; is left out</source>
        <translation>son &lt;%1&gt; est omis</translation>
    </message>
    <message>
        <source>HDF5 files need wend-hdf5, which is missing beside the program: it is built where libhdf5-dev is installed</source>
        <translation>les fichiers HDF5 nécessitent wend-hdf5, qui manque à côté du programme : il est compilé là où libhdf5-dev est installé</translation>
    </message>
    <message>
        <source>the HDF5 library fails on it: the file may be damaged</source>
        <translation>la bibliothèque HDF5 échoue : le fichier est peut-être endommagé</translation>
    </message>
    <message>
        <source>is no HDF5 file</source>
        <translation>n’est pas un fichier HDF5</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along a face whose triangles do not match (near %3): give both the same triangles there or leave a gap</source>
        <translation>les corps %1 et %2 se touchent le long d’une face dont les triangles ne correspondent pas (près de %3) : donnez-leur les mêmes triangles à cet endroit ou laissez un espace</translation>
    </message>
    <message>
        <source>bodies %1 and %2 touch along an edge or at a point (near %3): give both the same triangles there or leave a gap</source>
        <translation>les corps %1 et %2 se touchent le long d’une arête ou en un point (près de %3) : donnez-leur les mêmes triangles à cet endroit ou laissez un espace</translation>
    </message>
    <message>
        <source>1 vertex belongs to no cell; it lies at the place of another and moves with it. It stays in what is written: some solvers want it taken out first</source>
        <translation>1 sommet n&apos;appartient à aucune cellule ; il coïncide avec un autre et se déplace avec lui. Il reste dans ce qui est écrit : certains solveurs veulent qu&apos;on l&apos;ôte d&apos;abord</translation>
    </message>
    <message>
        <source>%1 vertices belong to no cell; %2 of them lie at the place of another and move with it. They stay in what is written: some solvers want them taken out first</source>
        <translation>%1 sommets n’appartiennent à aucune cellule ; %2 d’entre eux coïncident avec un autre et se déplacent avec lui. Ils restent dans ce qui est écrit : certains solveurs veulent qu’on les retire d’abord</translation>
    </message>
    <message>
        <source>%1: the surface is kept as it is and forces it, at its triangles %2 and %3 more</source>
        <translation>%1 : la surface est gardée telle quelle et l’impose, à ses triangles %2 et %3 autres</translation>
    </message>
    <message>
        <source>the layer &quot;%1&quot; has the blend mode %2: it is shown as normal</source>
        <translation>le calque « %1 » a le mode de fusion %2 : il est affiché comme normal</translation>
    </message>
    <message>
        <source>1 hole of %1 edges stayed open, larger than the limit of %2</source>
        <translation>1 trou de %1 arêtes est resté ouvert, plus grand que la limite de %2</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 edges stayed open, larger than the limit of %3</source>
        <translation>%1 trous de %2 arêtes au plus sont restés ouverts, plus grands que la limite de %3</translation>
    </message>
    <message>
        <source>1 vertex of open seams welded, the widest gap %1</source>
        <translation>1 sommet de coutures ouvertes soudé, l’écart le plus large %1</translation>
    </message>
    <message>
        <source>%1 vertices of open seams welded, the widest gap %2</source>
        <translation>%1 sommets de coutures ouvertes soudés, l’écart le plus large %2</translation>
    </message>
    <message>
        <source> (after the repair: %1)</source>
        <translation> (après la réparation : %1)</translation>
    </message>
    <message>
        <source>; the repair found nothing that it could repair</source>
        <translation> ; la réparation n’a rien trouvé qu’elle puisse réparer</translation>
    </message>
    <message>
        <source>%1 and %2 move the joint at %3 in different ways at time %4</source>
        <translation>%1 et %2 déplacent différemment l’articulation en %3 au temps %4</translation>
    </message>
    <message>
        <source>the multigrid solver did not find the velocities near %1; solve directly (--solver direct), or make the material or the mesh more even</source>
        <translation>le solveur multigrille n’a pas trouvé les vitesses près de %1 ; résolvez directement (--solver direct) ou rendez la matière ou le maillage plus réguliers</translation>
    </message>
    <message>
        <source>%1: its points have any number of coordinates; only points in space, which have three, are read</source>
        <translation>%1 : ses points ont un nombre quelconque de coordonnées ; seuls les points de l’espace, qui en ont trois, sont lus</translation>
    </message>
    <message>
        <source>%1 vertex that is not finite (first: %2)</source>
        <translation>%1 sommet non fini (%2)</translation>
    </message>
    <message>
        <source>%1 vertices that are not finite (first: %2)</source>
        <translation>%1 sommets non finis (d’abord %2)</translation>
    </message>
    <message>
        <source>%1 triangle that names a missing vertex (first: %2)</source>
        <translation>%1 triangle qui nomme un sommet absent (%2)</translation>
    </message>
    <message>
        <source>%1 triangles that name a missing vertex (first: %2)</source>
        <translation>%1 triangles qui nomment un sommet absent (d’abord %2)</translation>
    </message>
    <message>
        <source>an IFF file</source>
        <translation>un fichier IFF</translation>
    </message>
    <message>
        <source>a KTX texture</source>
        <translation>une texture KTX</translation>
    </message>
    <message>
        <source>a PostScript document</source>
        <translation>un document PostScript</translation>
    </message>
    <message>
        <source>a PAM picture</source>
        <translation>une image PAM</translation>
    </message>
    <message>
        <source>a Windows cursor</source>
        <translation>un curseur Windows</translation>
    </message>
    <message>
        <source>a QOI picture</source>
        <translation>une image QOI</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 2 GB, these layers have more</source>
        <translation>ne peut pas être écrit&#x202f;: un fichier Photoshop a au plus 2 Go, et ces calques en ont davantage</translation>
    </message>
    <message>
        <source>cannot be written: a Photoshop file has at most 30000 pixels a side</source>
        <translation>ne peut pas être écrit&#x202f;: un fichier Photoshop a au plus 30000 pixels de côté</translation>
    </message>
    <message>
        <source>the shape is too stiff to settle further near %1: the steps would be too short; allow a larger tolerance</source>
        <translation>la forme est trop raide près de %1 pour se reposer davantage&#x202f;: les pas seraient trop courts&#x202f;; autorisez une plus grande tolérance</translation>
    </message>
    <message>
        <source>%1 cannot go on: %2</source>
        <translation>%1 ne peut pas continuer&#x202f;: %2</translation>
    </message>
    <message>
        <source>at time %1 the shape snaps to another equilibrium near %2, and once more</source>
        <translation>au temps %1 la forme saute vers un autre équilibre près de %2, et une fois encore</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2</source>
        <translation>à %1 s, la forme saute vers une autre pose près de %2</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and once more</source>
        <translation>à %1 s, la forme saute vers une autre pose près de %2, et une fois encore</translation>
    </message>
    <message>
        <source>at %1 s the shape jumps to another pose near %2, and %3 times more</source>
        <translation>à %1 s, la forme saute vers une autre pose près de %2, et %3 fois encore</translation>
    </message>
</context>
<context>
    <name>CropTool</name>
    <message>
        <source>Drag a rectangle around what exports keep, then drag its inside or its sides; Shift keeps the proportions, Delete or a double-click removes it</source>
        <translation>Tracez un rectangle autour de ce que gardent les exports&#x202f;; faites glisser l’intérieur ou les côtés&#x202f;; Maj garde les proportions, Suppr ou un double clic l’enlève</translation>
    </message>
</context>
<context>
    <name>CurveEditor</name>
    <message>
        <source>Double-click to insert a point into the curve</source>
        <translation>Double-cliquez pour insérer un point dans la courbe</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>Modifier la courbe</translation>
    </message>
    <message>
        <source>Insert curve point</source>
        <translation>Insérer un point de courbe</translation>
    </message>
    <message>
        <source>Delete curve point</source>
        <translation>Supprimer un point de courbe</translation>
    </message>
    <message>
        <source>The ends of a curve must stay.</source>
        <translation>Les extrémités d’une courbe doivent rester.</translation>
    </message>
    <message>
        <source>Drag the curve&apos;s point, Shift keeps it straight, Ctrl moves one direction only; Delete removes it, a right-click shows more</source>
        <translation>Tirez le point de la courbe, tout droit avec Maj, une seule direction avec Ctrl&#x202f;; Suppr le supprime, le clic droit offre plus</translation>
    </message>
</context>
<context>
    <name>CutTool</name>
    <message>
        <source>Drag the arrow to move the cut, the rings to tilt it; Esc puts it back</source>
        <translation>Tirez la flèche pour déplacer la coupe, les anneaux pour l’incliner&#x202f;; Échap la remet en place</translation>
    </message>
</context>
<context>
    <name>DepthTool</name>
    <message>
        <source>Brush over what lies in front or behind; Ctrl clears it, Shift swaps front and back, [ and ] change the size</source>
        <translation>Passez le pinceau sur ce qui est devant ou derrière&#x202f;; Ctrl l’annule, Maj l’inverse, [ et ] changent la taille</translation>
    </message>
    <message>
        <source>Paint in front</source>
        <translation>Peindre devant</translation>
    </message>
    <message>
        <source>Paint behind</source>
        <translation>Peindre derrière</translation>
    </message>
    <message>
        <source>Clear depth</source>
        <translation>Effacer la profondeur</translation>
    </message>
</context>
<context>
    <name>EaseNames</name>
    <message>
        <source>Ease &amp;In</source>
        <translation>Accélération (ease &amp;in)</translation>
    </message>
    <message>
        <source>Ease &amp;Out</source>
        <translation>Décélération (ease &amp;out)</translation>
    </message>
    <message>
        <source>Ease In and O&amp;ut</source>
        <translation>Les de&amp;ux (ease in-out)</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linéaire</translation>
    </message>
</context>
<context>
    <name>EnergyScale</name>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Nothing grows or shrinks. Parts may get thin.</source>
        <translation>Rien ne grandit ni ne rétrécit. Certaines parties peuvent s’amincir.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Stretches least. Start here.</source>
        <translation>Étire le moins. Commencez ici.</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Rigide</translation>
    </message>
    <message>
        <source>Parts turn like card.</source>
        <translation>Les parties tournent comme du carton.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Details keep their look. Parts may swell.</source>
        <translation>Les détails gardent leur aspect. Certaines parties peuvent gonfler.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
</context>
<context>
    <name>ExportFormats</name>
    <message>
        <source>Layers (OpenRaster)</source>
        <translation>Calques (OpenRaster)</translation>
    </message>
    <message>
        <source>This film is made by the program ffmpeg, which is not installed (Debian: sudo apt install ffmpeg). Animated WebP needs no other program.</source>
        <translation>Ce film est fait par le programme ffmpeg, qui n’est pas installé (Debian : sudo apt install ffmpeg). Le WebP animé n’a besoin d’aucun autre programme.</translation>
    </message>
    <message>
        <source>glTF film</source>
        <translation>Film glTF</translation>
    </message>
    <message>
        <source>Spine skeleton</source>
        <translation>Squelette Spine</translation>
    </message>
    <message>
        <source>DragonBones skeleton</source>
        <translation>Squelette DragonBones</translation>
    </message>
    <message>
        <source>Layers (Photoshop)</source>
        <translation>Calques (Photoshop)</translation>
    </message>
</context>
<context>
    <name>FileCard</name>
    <message>
        <source>Eyes stay round</source>
        <translation>Des yeux ronds</translation>
    </message>
    <message>
        <source>Pins and paths</source>
        <translation>Trajectoires</translation>
    </message>
    <message>
        <source>Many pins at once</source>
        <translation>Des épingles</translation>
    </message>
    <message>
        <source>Flight, with a skin</source>
        <translation>Vol avec peau</translation>
    </message>
    <message>
        <source>A stiff middle</source>
        <translation>Milieu raide</translation>
    </message>
    <message>
        <source>Frog</source>
        <translation>Grenouille</translation>
    </message>
    <message>
        <source>Giraffe</source>
        <translation>Girafe</translation>
    </message>
    <message>
        <source>Octopus</source>
        <translation>Pieuvre</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Bande</translation>
    </message>
    <message>
        <source>Eagle</source>
        <translation>Aigle</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>Barre</translation>
    </message>
    <message>
        <source>Choose what to keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Marcheur</translation>
    </message>
    <message>
        <source>A walk that loops</source>
        <translation>Marche en boucle</translation>
    </message>
</context>
<context>
    <name>FillTool</name>
    <message>
        <source>Click to pick up what is painted there</source>
        <translation>Cliquez pour prélever ce qui est peint là</translation>
    </message>
    <message>
        <source>Click to fill a connected area; Shift fills everything, Ctrl erases, Alt picks up</source>
        <translation>Cliquez pour remplir la zone contiguë&#x202f;; Maj remplit tout, Ctrl retire la peinture, Alt prélève</translation>
    </message>
    <message>
        <source>Fill with %1</source>
        <translation>Remplir&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>GrabTool</name>
    <message>
        <source>Draw around the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>Entourez la partie à maintenir&#x202f;; Maj ajoute à la partie sélectionnée, Ctrl retire</translation>
    </message>
    <message>
        <source>Brush over the part to hold, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>Passez le pinceau sur la partie à maintenir, [ et ] changent la taille&#x202f;; Maj ajoute, Ctrl retire</translation>
    </message>
    <message>
        <source>Draw a rectangle over the part to hold; Shift adds to the selected part, Ctrl takes away</source>
        <translation>Tracez un rectangle sur la partie à maintenir&#x202f;; Maj ajoute à la partie sélectionnée, Ctrl retire</translation>
    </message>
    <message>
        <source>Part</source>
        <translation>Partie</translation>
    </message>
    <message>
        <source>No part of the shape lies in this outline.</source>
        <translation>Ce contour ne contient rien de la forme.</translation>
    </message>
    <message>
        <source>Select one part to take away from.</source>
        <translation>Sélectionnez une seule partie pour en retirer.</translation>
    </message>
    <message>
        <source>A handle must hold something; Delete removes it.</source>
        <translation>Une poignée ne peut pas rester vide&#x202f;: supprimez-la avec Suppr.</translation>
    </message>
</context>
<context>
    <name>GradientTool</name>
    <message>
        <source>Move gradient</source>
        <translation>Déplacer le dégradé</translation>
    </message>
    <message>
        <source>To %1</source>
        <translation>Vers %1</translation>
    </message>
    <message>
        <source>Blend to %1</source>
        <translation>Dégradé vers %1</translation>
    </message>
    <message>
        <source>Drag over the shape to blend evenly from what is there to what is chosen on the right; Shift snaps to 45°, Alt picks up, Esc cancels</source>
        <translation>Glissez sur la forme&#x202f;: ce qui s’y trouve passe progressivement à ce qui est choisi à droite&#x202f;; Maj par pas de 45°, Alt prélève, Échap annule</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>Stretch</source>
        <translation>Étirement</translation>
    </message>
    <message>
        <source>stretch %1</source>
        <translation>étirement %1</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>area ×%1</source>
        <translation>aire ×%1</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>volume ×%1</source>
        <translation>volume ×%1</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>angle error %1</source>
        <translation>erreur d’angle %1</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Cisaillement</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Cell size</source>
        <translation>Taille de cellule</translation>
    </message>
    <message>
        <source>Distance from rest</source>
        <translation>Distance au repos</translation>
    </message>
    <message>
        <source>Influence of the pin</source>
        <translation>Influence de l’épingle</translation>
    </message>
    <message>
        <source>Stretched too far here · %1</source>
        <translation>Trop étiré ici · %1</translation>
    </message>
    <message>
        <source>Grown too far here · %1</source>
        <translation>Trop agrandi ici · %1</translation>
    </message>
    <message>
        <source>Shrunk too far here · %1</source>
        <translation>Trop rétréci ici · %1</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Scaled Jacobian</source>
        <translation>Jacobien normalisé</translation>
    </message>
    <message>
        <source>Aspect ratio</source>
        <translation>Rapport d’aspect</translation>
    </message>
    <message>
        <source>Smallest angle</source>
        <translation>Plus petit angle</translation>
    </message>
    <message>
        <source>Smallest dihedral angle</source>
        <translation>Plus petit angle dièdre</translation>
    </message>
</context>
<context>
    <name>MeasureTool</name>
    <message>
        <source>Click two points for a length, a third for the angle; Ctrl snaps to vertices, Esc clears</source>
        <translation>Cliquez deux points pour une longueur, un troisième pour l’angle&#x202f;; Ctrl prend des sommets, Échap efface</translation>
    </message>
    <message>
        <source>angle %1, at rest %2</source>
        <translation>angle %1, au repos %2</translation>
    </message>
    <message>
        <source>length %1, at rest %2</source>
        <translation>longueur %1, au repos %2</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>Trait</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>Det&amp;ail, in vertices</source>
        <translation>Détai&amp;l, en sommets</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>How fine the mesh is. More vertices bend more smoothly and take longer.</source>
        <translation>Finesse du maillage. Avec plus de sommets, la forme se courbe plus doucement, mais c’est plus long.</translation>
    </message>
    <message>
        <source>Change detail</source>
        <translation>Modifier le détail</translation>
    </message>
    <message>
        <source>&amp;Outline</source>
        <translation>Co&amp;ntour</translation>
    </message>
    <message>
        <source>Change outline</source>
        <translation>Modifier le contour</translation>
    </message>
    <message>
        <source>Whole picture</source>
        <translation>Image entière</translation>
    </message>
    <message>
        <source>Cut-out</source>
        <translation>Détourage</translation>
    </message>
    <message>
        <source>Drawn polygons</source>
        <translation>Polygones tracés</translation>
    </message>
    <message>
        <source>Pixels that are more opaque than this belong to the shape.</source>
        <translation>Les pixels plus opaques que cette valeur font partie de la forme.</translation>
    </message>
    <message>
        <source>Change what counts as solid</source>
        <translation>Modifier le seuil d’opacité</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Ma&amp;rgin</source>
        <translation>Mar&amp;ge</translation>
    </message>
    <message>
        <source>The outline grows by this much, so that soft edges are kept whole.</source>
        <translation>Le contour est élargi d’autant, pour que les bords doux suivent en entier.</translation>
    </message>
    <message>
        <source>Change margin</source>
        <translation>Modifier la marge</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation>&amp;Bord</translation>
    </message>
    <message>
        <source>Picture&apos;s border</source>
        <translation>Bord de l’image</translation>
    </message>
    <message>
        <source>Holds the frame of a photograph, so that no gap opens at its edge: it stays where it is, or its sides slide along themselves. Pins on it still move.</source>
        <translation>Maintient le cadre d’une photo, pour qu’aucun vide ne s’ouvre à côté&#x202f;: il reste en place, ou ses côtés glissent sur eux-mêmes. Les épingles posées dessus bougent quand même.</translation>
    </message>
    <message>
        <source>Hold the border</source>
        <translation>Maintenir le bord</translation>
    </message>
    <message>
        <source>Moves freely</source>
        <translation>Bouge librement</translation>
    </message>
    <message>
        <source>Stays in place</source>
        <translation>Reste en place</translation>
    </message>
    <message>
        <source>Slides along itself</source>
        <translation>Glisse sur lui-même</translation>
    </message>
    <message>
        <source>Radius–edge rati&amp;o</source>
        <translation>Ra&amp;yon–arête</translation>
    </message>
    <message>
        <source>How flat the tetrahedra may be: the maximum ratio of circumradius to shortest edge. Smaller is rounder and takes more of them.</source>
        <translation>Aplatissement permis des tétraèdres&#x202f;: rapport maximal entre le rayon circonscrit et la plus petite arête. Plus il est petit, plus ils sont ronds et nombreux.</translation>
    </message>
    <message>
        <source>Change radius–edge ratio</source>
        <translation>Modifier le rapport rayon–arête</translation>
    </message>
    <message>
        <source>Ma&amp;ximum volume</source>
        <translation>&amp;Volume maximal</translation>
    </message>
    <message>
        <source>Larger tetrahedra are split; in the file&apos;s units, cubed. Half the volume makes about twice as many. At a surface that is kept, some may stay larger.</source>
        <translation>Les tétraèdres plus grands sont divisés&#x202f;; en unités du fichier au cube. Diviser la valeur par deux double à peu près leur nombre. Le long d’une surface conservée, certains peuvent rester plus grands.</translation>
    </message>
    <message>
        <source>Change maximum volume</source>
        <translation>Modifier le volume maximal</translation>
    </message>
    <message>
        <source>Refine s&amp;urface</source>
        <translation>Raffiner la s&amp;urface</translation>
    </message>
    <message>
        <source>Allows the surface&apos;s triangles to be split where they are larger than the tetrahedra inside. If off, the surface is kept exactly as it is.</source>
        <translation>Permet de diviser les triangles de la surface plus grands que les tétraèdres intérieurs. Sinon, la surface est conservée telle quelle.</translation>
    </message>
    <message>
        <source>Refine surface</source>
        <translation>Raffiner la surface</translation>
    </message>
    <message>
        <source>Fill holes up to (edges)</source>
        <translation>Boucher les trous (arêtes)</translation>
    </message>
    <message>
        <source>Largest hole</source>
        <translation>Trou maximal</translation>
    </message>
    <message>
        <source>“Repair” fills holes of at most this many edges.</source>
        <translation>«&#x202f;Réparer&#x202f;» bouche les trous d’au plus ce nombre d’arêtes.</translation>
    </message>
    <message>
        <source>F&amp;it</source>
        <translation>Rem&amp;plissage</translation>
    </message>
    <message>
        <source>What is filled: the surface itself, or a cage of even cells around it, in which it is embedded. Automatic takes the cage where the surface cannot be filled or has far too many vertices.</source>
        <translation>Ce qui est rempli&#x202f;: la surface elle-même, ou une cage de cellules uniformes qui l’entoure et l’entraîne. Automatique choisit la cage si la surface ne peut pas être remplie ou a beaucoup trop de sommets.</translation>
    </message>
    <message>
        <source>Change fit</source>
        <translation>Modifier le remplissage</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatique</translation>
    </message>
    <message>
        <source>Exact surface</source>
        <translation>Surface exacte</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>Exact &amp;balance</source>
        <translation>Valeur e&amp;xacte</translation>
    </message>
    <message>
        <source>Change energy</source>
        <translation>Modifier l’énergie</translation>
    </message>
    <message>
        <source> rad</source>
        <translation> rad</translation>
    </message>
    <message>
        <source>Smoothi&amp;ng length</source>
        <translation>Lon&amp;gueur de lissage</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads, as a fraction of the shape&apos;s size. Small: close to the pin, sharp. Large: soft and wide.</source>
        <translation>Jusqu’où se répartit la traction d’une épingle, par rapport à la taille de la forme. Petite&#x202f;: près de l’épingle, net. Grande&#x202f;: large et doux.</translation>
    </message>
    <message>
        <source>Change smoothing</source>
        <translation>Modifier le lissage</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>number of frames, evenly spaced from the start to the last time</source>
        <translation>nombre d’images, à intervalles égaux du début à la fin</translation>
    </message>
    <message>
        <source>F&amp;rames</source>
        <translation>&amp;Images</translation>
    </message>
    <message>
        <source>whether distortion, φ, directions and velocity are written with meshes, in formats that carry values</source>
        <translation>si la distorsion, φ, les directions et la vitesse accompagnent les maillages, dans les formats qui portent des valeurs</translation>
    </message>
    <message>
        <source>&amp;Values</source>
        <translation>&amp;Valeurs</translation>
    </message>
    <message>
        <source>Errors, material, velocity</source>
        <translation>Erreurs, matériau, vitesse</translation>
    </message>
    <message>
        <source>The shape alone</source>
        <translation>La forme seule</translation>
    </message>
    <message>
        <source>how numbers are stored in mesh files that offer a choice (ply, stl, msh, vtk, vtu)</source>
        <translation>écriture des nombres dans les maillages qui en offrent plusieurs (ply, stl, msh, vtk, vtu)</translation>
    </message>
    <message>
        <source>&amp;Numbers</source>
        <translation>&amp;Nombres</translation>
    </message>
    <message>
        <source>As text</source>
        <translation>En texte</translation>
    </message>
    <message>
        <source>Binary</source>
        <translation>Binaire</translation>
    </message>
    <message>
        <source>Binary, compressed</source>
        <translation>Binaire, compressé</translation>
    </message>
    <message>
        <source>version of .msh files</source>
        <translation>version des fichiers .msh</translation>
    </message>
    <message>
        <source>&amp;Gmsh version</source>
        <translation>Version &amp;Gmsh</translation>
    </message>
    <message>
        <source>write the triangles of a solid&apos;s border as cells too, with the values of the tetrahedra behind them; without it .vtu and .vtk hold tetrahedra only, unless the input had such triangles</source>
        <translation>écrire aussi comme cellules les triangles du bord d’un solide, avec les valeurs des tétraèdres derrière eux&#x202f;; sinon .vtu et .vtk ne contiennent que des tétraèdres, sauf si l’entrée avait de tels triangles</translation>
    </message>
    <message>
        <source>&amp;Border triangles</source>
        <translation>&amp;Triangles du bord</translation>
    </message>
    <message>
        <source>how the picture is sampled</source>
        <translation>manière d’échantillonner l’image</translation>
    </message>
    <message>
        <source>Fil&amp;ter</source>
        <translation>&amp;Filtre</translation>
    </message>
    <message>
        <source>Nearest – hard pixels</source>
        <translation>Au plus proche – pixels nets</translation>
    </message>
    <message>
        <source>Bilinear – quick</source>
        <translation>Bilinéaire – rapide</translation>
    </message>
    <message>
        <source>Bicubic – sharp</source>
        <translation>Bicubique – précis</translation>
    </message>
    <message>
        <source>EWA – best</source>
        <translation>EWA – le meilleur</translation>
    </message>
    <message>
        <source>&amp;Canvas</source>
        <translation>&amp;Toile</translation>
    </message>
    <message>
        <source>As large as the picture</source>
        <translation>Aussi grande que l’image</translation>
    </message>
    <message>
        <source>Fit to the shape</source>
        <translation>Ajustée à la forme</translation>
    </message>
    <message>
        <source>bits per channel in pictures: as in the source, 8 or 16, or half or full floating point; values stay what they are</source>
        <translation>bits par couche des images&#x202f;: comme l’original, 8 ou 16, ou en virgule flottante, demi ou simple&#x202f;; les valeurs ne changent pas</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>&amp;Profondeur</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>Comme dans l’image</translation>
    </message>
    <message>
        <source>8 bit</source>
        <translation>8 bits</translation>
    </message>
    <message>
        <source>16 bit</source>
        <translation>16 bits</translation>
    </message>
    <message>
        <source>16 bit floating point (half)</source>
        <translation>16 bits en virgule flottante (half)</translation>
    </message>
    <message>
        <source>32 bit floating point</source>
        <translation>32 bits en virgule flottante</translation>
    </message>
    <message>
        <source>what pictures show around the shape: nothing, its border drawn outwards, the source as it was, or a colour</source>
        <translation>ce que les images montrent à côté de la forme&#x202f;: rien, son bord prolongé, l’original tel quel ou une couleur</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Arrière-plan</translation>
    </message>
    <message>
        <source>Transparent</source>
        <translation>Transparent</translation>
    </message>
    <message>
        <source>The border, drawn outwards</source>
        <translation>Le bord, prolongé</translation>
    </message>
    <message>
        <source>The picture as it was</source>
        <translation>L’image d’origine</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Blanc</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Noir</translation>
    </message>
    <message>
        <source>How far apart growing the outline keeps parts and limbs, so that they do not become one.</source>
        <translation>L’agrandissement tient les parties et les membres à cette distance, pour qu’ils ne fassent pas qu’un.</translation>
    </message>
    <message>
        <source>Change gap</source>
        <translation>Modifier l’écart</translation>
    </message>
    <message>
        <source>Parts and holes of fewer pixels, such as dust around a drawing, are left out.</source>
        <translation>Les parties et les trous de moins de pixels, comme la poussière autour d’un dessin, sont ignorés.</translation>
    </message>
    <message>
        <source>Change what is left out</source>
        <translation>Modifier ce qui est ignoré</translation>
    </message>
    <message>
        <source>&amp;Gap</source>
        <translation>É&amp;cart</translation>
    </message>
    <message>
        <source>Drop &amp;below</source>
        <translation>&amp;Ignorer sous</translation>
    </message>
    <message>
        <source>Change up axis</source>
        <translation>Modifier l’axe vertical</translation>
    </message>
    <message>
        <source>pixels that pictures show: those of the source, as many as the shape needs, or those of a rectangle X,Y,WIDTH,HEIGHT of the source, which may reach beyond it</source>
        <translation>pixels que montrent les images&#x202f;: ceux de la source, autant que la forme en demande, ou ceux d’un rectangle X,Y,LARGEUR,HAUTEUR de la source, qui peut la dépasser</translation>
    </message>
    <message>
        <source>Another colour …</source>
        <translation>Autre couleur …</translation>
    </message>
    <message>
        <source>R&amp;ate</source>
        <translation>&amp;Cadence</translation>
    </message>
    <message>
        <source> fps</source>
        <translation> i/s</translation>
    </message>
    <message>
        <source>whether WebP pictures and films keep every pixel, or are a fraction of the size with hardly visible losses</source>
        <translation>si les images et films WebP gardent chaque pixel ou ne font qu’une fraction de la taille, avec des pertes à peine visibles</translation>
    </message>
    <message>
        <source>&amp;Quality</source>
        <translation>&amp;Qualité</translation>
    </message>
    <message>
        <source>Every pixel – lossless</source>
        <translation>Chaque pixel – sans perte</translation>
    </message>
    <message>
        <source>Smaller file – lossy</source>
        <translation>Fichier plus petit – avec pertes</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>Retour élastique</translation>
    </message>
    <message>
        <source>Lead a pin around and back: how far does the shape come back, too? Not at all: where it ends depends on the path. Fully: it is as it was.</source>
        <translation>Une épingle fait un tour et revient : à quel point la forme revient-elle aussi ? Aucun : sa forme finale dépend du chemin. Total : elle est comme avant.</translation>
    </message>
    <message>
        <source>Change springing back</source>
        <translation>Modifier le retour élastique</translation>
    </message>
    <message>
        <source>Opa&amp;que from</source>
        <translation>Opa&amp;que à partir de</translation>
    </message>
    <message>
        <source>Keep as a number φ, as in the project file: 0.002 keeps area or volume, 0.464 length, 1.571 is rigid, 2.678 keeps angles (2.498 in a solid).</source>
        <translation>Conserver sous forme du nombre φ, comme dans le fichier du projet : 0,002 conserve l’aire ou le volume, 0,464 la longueur, 1,571 est rigide, 2,678 conserve les angles (2,498 pour un solide).</translation>
    </message>
    <message>
        <source>What bends: only what is opaque in the picture, this with what its lines enclose, or the picture as a whole.</source>
        <translation>Ce qui se plie : seulement ce qui est opaque dans l’image, cela avec ce que ses traits entourent, ou l’image entière.</translation>
    </message>
    <message>
        <source>Cut-out, holes filled</source>
        <translation>Détourage, trous remplis</translation>
    </message>
    <message>
        <source>Change solver</source>
        <translation>Changer le solveur</translation>
    </message>
    <message>
        <source>frames per second of a film; a unit of time is a second</source>
        <translation>images par seconde d’un film ; une unité de temps est une seconde</translation>
    </message>
    <message>
        <source>Change frame rate</source>
        <translation>Changer la fréquence d’images</translation>
    </message>
    <message>
        <source>leave the last frame out, which is the first one again: for films that repeat; if the project has a cycle, show that</source>
        <translation>omettre la dernière image, qui est à nouveau la première : pour les films qui se répètent ; si le projet a un cycle, le montrer</translation>
    </message>
    <message>
        <source>Loop: no fra&amp;me twice</source>
        <translation>Boucle : aucune image deu&amp;x fois</translation>
    </message>
    <message>
        <source>size of pictures in percent of the canvas; that of frames becomes even</source>
        <translation>taille des images en pourcentage du canevas ; celle des images d’un film devient paire</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>&amp;Taille</translation>
    </message>
    <message>
        <source>width of pictures, instead of a size in percent</source>
        <translation>largeur des images, au lieu d’une taille en pourcentage</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>Inner she&amp;lls</source>
        <translation>Co&amp;ques intérieures</translation>
    </message>
    <message>
        <source>What is inside of shells that lie one in the other: holes, or regions of their own, whose cells are labelled. Bodies that share walls are all filled and labelled.</source>
        <translation>Ce qu’il y a dans des coques emboîtées : des trous, ou des régions propres dont les cellules portent une étiquette. Les corps à parois communes sont tous remplis et étiquetés.</translation>
    </message>
    <message>
        <source>Change inner shells</source>
        <translation>Modifier les coques intérieures</translation>
    </message>
    <message>
        <source>Holes, and say so</source>
        <translation>Trous, en le signalant</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Trous</translation>
    </message>
    <message>
        <source>Regions</source>
        <translation>Régions</translation>
    </message>
</context>
<context>
    <name>OutlineTool</name>
    <message>
        <source>Draw around what should bend, too; Ctrl takes it away, Esc cancels</source>
        <translation>Entourez ce qui doit aussi se déformer&#x202f;; avec Ctrl, c’est retiré. Échap annule</translation>
    </message>
    <message>
        <source>Brush over what should bend, too; Ctrl takes it away, [ and ] change the size</source>
        <translation>Passez le pinceau sur ce qui doit aussi se déformer, [ et ] changent la taille&#x202f;; Ctrl retire</translation>
    </message>
    <message>
        <source>Click a colour that should bend, too; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>Cliquez sur une couleur qui doit aussi se déformer&#x202f;; Ctrl la retire, [ et ] prennent moins ou plus de couleurs</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape; Esc cancels</source>
        <translation>Tracez une ligne le long de laquelle séparer la forme&#x202f;; Échap annule</translation>
    </message>
    <message>
        <source>Nothing would be left of the shape.</source>
        <translation>Il ne resterait rien de la forme.</translation>
    </message>
    <message numerus="yes">
        <source>Pins outside the new outline were removed: %n.</source>
        <translation>
            <numerusform>%n épingle se trouvait hors du nouveau contour et a été supprimée.</numerusform>
            <numerusform>%n épingles se trouvaient hors du nouveau contour et ont été supprimées.</numerusform>
        </translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Séparer</translation>
    </message>
    <message>
        <source>Take away from the outline</source>
        <translation>Retirer du contour</translation>
    </message>
    <message>
        <source>Add to the outline</source>
        <translation>Ajouter au contour</translation>
    </message>
    <message>
        <source>The tolerance, or [ and ], changes what was taken; click another colour to take it too, with Ctrl to take it away</source>
        <translation>La tolérance, aussi [ et ], change ce qui a été pris ; cliquez sur une autre couleur, avec Ctrl elle est retirée</translation>
    </message>
    <message>
        <source>That was a line. Draw around a part of the picture.</source>
        <translation>C’était une ligne. Entourez une partie de l’image.</translation>
    </message>
    <message>
        <source>From now on the outline is as you draw it, and has no margin to change. Choose “Cut-out” as the outline to go back to the one that was found.</source>
        <translation>Le contour est désormais tel que vous le dessinez, sans marge à régler. « Détourage » comme contour rétablit celui qui a été trouvé.</translation>
    </message>
    <message>
        <source>Draw around what should bend; Ctrl takes it away, Esc cancels</source>
        <translation>Entourez ce qui doit se déformer&#x202f;; avec Ctrl, c’est retiré. Échap annule</translation>
    </message>
    <message>
        <source>Click corner by corner, Shift snaps to 45°, a double-click closes; Ctrl takes away, Backspace removes the last corner, Esc cancels</source>
        <translation>Cliquez coin après coin, Maj par pas de 45°, le double-clic ferme&#x202f;; Ctrl retire, Retour arrière reprend un coin, Échap annule</translation>
    </message>
    <message>
        <source>Brush over what should bend; Ctrl takes it away, [ and ] change the size</source>
        <translation>Passez le pinceau sur ce qui doit se déformer, [ et ] changent la taille&#x202f;; Ctrl retire</translation>
    </message>
    <message>
        <source>Click a colour that should bend; Ctrl takes it away, [ and ] take fewer or more colours</source>
        <translation>Cliquez sur une couleur qui doit se déformer&#x202f;; Ctrl la retire, [ et ] prennent moins ou plus de couleurs</translation>
    </message>
    <message>
        <source>Mark what becomes a part of its own, up to where it hangs on the rest; Esc cancels</source>
        <translation>Délimitez ce qui devient une partie à part, jusqu’à son attache au reste ; Échap annule</translation>
    </message>
    <message>
        <source>This picture has parts: choose the one in the list that this outline is for, or Make a Part to cut another one out.</source>
        <translation>Cette image a des parties&#x202f;: choisissez dans la liste celle à laquelle ce contour est destiné, ou Créer une partie pour en découper une autre.</translation>
    </message>
    <message>
        <source>“%1” is locked. The list of parts unlocks it.</source>
        <translation>« %1 » est verrouillée. La liste des parties la déverrouille.</translation>
    </message>
</context>
<context>
    <name>PaintTool</name>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>Rigid</source>
        <translation>Rigide</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Combed</source>
        <translation>Peigné</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Lissé</translation>
    </message>
    <message>
        <source>Erase paint from %1</source>
        <translation>Retirer la peinture de %1</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>Lisser %1</translation>
    </message>
    <message>
        <source>Comb %1</source>
        <translation>Peigner %1</translation>
    </message>
    <message>
        <source>Paint %1 on %2</source>
        <translation>Peindre %1 sur %2</translation>
    </message>
    <message>
        <source>There is no direction to follow: the numbers on the right were used.</source>
        <translation>Il n’y a pas de direction à suivre&#x202f;: les nombres à droite ont été pris.</translation>
    </message>
    <message>
        <source>Comb along the direction in which it should be stiff; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>Peignez dans le sens où la forme doit être raide&#x202f;; Ctrl retire, Maj lisse, Maj+clic trace une ligne, Alt+clic prélève, Échap annule le trait</translation>
    </message>
    <message>
        <source>Paint what is chosen on the right; Ctrl erases, Shift smooths, Shift-click draws a line, Alt-click picks up, Esc cancels the stroke</source>
        <translation>Appliquez au pinceau ce qui est choisi à droite&#x202f;; Ctrl retire, Maj lisse, Maj+clic trace une ligne, Alt+clic prélève, Échap annule le trait</translation>
    </message>
    <message>
        <source>Stiffness ×1 is the same as everywhere and changes nothing: choose on the right how many times stiffer it should be</source>
        <translation>Une raideur de ×1 est comme partout et ne change rien ici&#x202f;: choisissez à droite combien de fois ce doit être plus raide</translation>
    </message>
    <message>
        <source>Erase paint</source>
        <translation>Retirer la peinture</translation>
    </message>
    <message>
        <source>Erases paint from all visible layers: brush over what should be like the rest again; Shift-click draws a line, Esc cancels the stroke</source>
        <translation>Retire la peinture de tous les calques visibles&#x202f;: passez le pinceau sur ce qui doit redevenir comme partout&#x202f;; Maj-clic trace une ligne, Échap abandonne le trait</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Comb</source>
        <translation>Peigner</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>Peindre %1</translation>
    </message>
    <message>
        <source>Nothing is painted there</source>
        <translation>Rien n’est peint à cet endroit</translation>
    </message>
</context>
<context>
    <name>PanTool</name>
    <message>
        <source>Drag to move the view; the wheel zooms</source>
        <translation>Tirez pour déplacer la vue ; la molette zoome</translation>
    </message>
</context>
<context>
    <name>PartMaking</name>
    <message>
        <source>There is nothing of the picture in this area.</source>
        <translation>Il n’y a rien de l’image dans cette zone.</translation>
    </message>
    <message>
        <source>Part %1</source>
        <translation>Partie %1</translation>
    </message>
    <message>
        <source>Make a part</source>
        <translation>Créer une partie</translation>
    </message>
    <message>
        <source>“%1” is a part now, joined to “%2” where it hangs on it. What is behind it is being filled.</source>
        <translation>« %1 » est maintenant une partie, jointe à « %2 » là où elle s’y attache. Ce qui est derrière est en cours de remplissage.</translation>
    </message>
    <message>
        <source>“%1” is a part now, cut from “%2”. What is behind it is being filled. Pin it, or join it under Parts.</source>
        <translation>« %1 » est maintenant une partie, découpée dans « %2 ». Ce qui est derrière est en cours de remplissage. Épinglez-la ou joignez-la sous Parties.</translation>
    </message>
    <message>
        <source>In this area is nothing but what is locked, if anything. The list of parts unlocks it.</source>
        <translation>Il n’y a dans cette zone rien d’autre que ce qui est verrouillé. La liste des parties le déverrouille.</translation>
    </message>
    <message>
        <source>The parts are still being made. Another one can be made as soon as they are there.</source>
        <translation>Les parties sont encore en cours de création. Une autre pourra être créée dès qu’elles seront là.</translation>
    </message>
</context>
<context>
    <name>PenTool</name>
    <message>
        <source>Click the pin whose path you want to draw</source>
        <translation>Cliquez sur l’épingle dont vous voulez dessiner la trajectoire</translation>
    </message>
    <message>
        <source>Click where the selected pin should go, point by point; drag for a smooth point</source>
        <translation>Cliquez point après point là où l’épingle sélectionnée doit aller ; tirez pour un point lisse</translation>
    </message>
    <message>
        <source>Click for a corner, drag for a smooth point, Shift snaps to 45°; Enter ends, Backspace removes the last point, Esc cancels</source>
        <translation>Cliquez pour un angle, glissez pour un point lisse, Maj par pas de 45°&#x202f;; Entrée termine, Retour arrière retire un point, Échap abandonne</translation>
    </message>
    <message>
        <source>Drag for a smooth point: Shift snaps to 45°, Ctrl or Alt moves this side only</source>
        <translation>Glissez pour un point lisse&#x202f;: Maj aligne sur 45°, Ctrl ou Alt ne déplace que ce côté</translation>
    </message>
</context>
<context>
    <name>PictureTip</name>
    <message>
        <source>near</source>
        <translation>près</translation>
    </message>
    <message>
        <source>far</source>
        <translation>loin</translation>
    </message>
    <message>
        <source>×1 everywhere</source>
        <translation>×1 partout</translation>
    </message>
    <message>
        <source>×50 along the left half</source>
        <translation>×50 le long de la moitié gauche</translation>
    </message>
    <message>
        <source>not at all</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>total</translation>
    </message>
    <message>
        <source>as it was pulled</source>
        <translation>telle que tirée</translation>
    </message>
    <message>
        <source>relaxed</source>
        <translation>détendue</translation>
    </message>
</context>
<context>
    <name>PinTool</name>
    <message>
        <source>Drag as far as the pin should hold; Esc cancels</source>
        <translation>Glissez jusqu’où l’épingle doit maintenir la forme&#x202f;; Échap annule</translation>
    </message>
    <message>
        <source>Drag the dot to rotate, Shift snaps to 15°, or the square to scale; digits set the number</source>
        <translation>Tirez le point pour faire pivoter, avec Maj par pas de 15°, ou le carré pour mettre à l’échelle&#x202f;; les chiffres fixent la valeur</translation>
    </message>
    <message>
        <source>%1: holds from %2 s</source>
        <translation>%1&#x202f;: tient à partir de %2 s</translation>
    </message>
    <message>
        <source>%1: released at %2 s</source>
        <translation>%1&#x202f;: lâchée à %2 s</translation>
    </message>
    <message>
        <source>Drag anywhere to rotate what is selected, Shift snaps to 15°, Ctrl records it; digits set the number</source>
        <translation>Tirez n’importe où pour faire pivoter la sélection, Maj par 15°, Ctrl l’enregistre ; les chiffres fixent la valeur</translation>
    </message>
    <message>
        <source>Drag anywhere to scale what is selected, Ctrl records it; digits set the number</source>
        <translation>Tirez n’importe où pour redimensionner la sélection, Ctrl l’enregistre ; les chiffres fixent la valeur</translation>
    </message>
    <message>
        <source>Drag an arrow, a square or a ring; G moves, R rotates, S scales</source>
        <translation>Tirez une flèche, un carré ou un anneau&#x202f;; G déplace, R fait pivoter, S met à l’échelle</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, draw around pins to select them</source>
        <translation>Cliquez sur la forme pour poser une épingle, tirez pour la déformer aussitôt ; à côté, entourez des épingles pour les sélectionner</translation>
    </message>
    <message>
        <source>Draw around pins to select them; Shift adds, Ctrl takes away</source>
        <translation>Entourez des épingles pour les sélectionner&#x202f;; Maj ajoute, Ctrl retire</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, drag to bend it at once; beside it, brush over pins, [ and ] change the size</source>
        <translation>Cliquez sur la forme pour poser une épingle, tirez pour la déformer aussitôt ; à côté, passez le pinceau sur des épingles, [ et ] changent la taille</translation>
    </message>
    <message>
        <source>Brush over pins to select them, [ and ] change the size; Shift adds, Ctrl takes away</source>
        <translation>Passez le pinceau sur des épingles pour les sélectionner, [ et ] changent la taille&#x202f;; Maj ajoute, Ctrl retire</translation>
    </message>
    <message>
        <source>Click on the shape to set a pin, or press and drag to bend it at once</source>
        <translation>Cliquez sur la forme pour poser une épingle, ou appuyez et tirez pour la déformer aussitôt</translation>
    </message>
    <message>
        <source>Click, or draw beside pins, to select; Shift adds, Ctrl takes away; drag or arrow keys move</source>
        <translation>Cliquez, ou tracez à côté des épingles, pour sélectionner&#x202f;; Maj ajoute, Ctrl retire&#x202f;; tirez ou utilisez les flèches pour déplacer</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y, Z lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Maj garde une ligne droite&#x202f;; X, Y, Z verrouillent un axe, les nombres fixent la valeur, Échap rétablit la forme</translation>
    </message>
    <message>
        <source>Shift keeps it straight; X, Y lock an axis, numbers set the amount, Esc puts the shape back</source>
        <translation>Maj garde une ligne droite&#x202f;; X, Y verrouillent un axe, les nombres fixent la valeur, Échap rétablit la forme</translation>
    </message>
    <message>
        <source>Drag to move the pin, Ctrl-drag to record it, Ctrl+Shift-drag to widen it, Shift-click to select more</source>
        <translation>Glissez pour déplacer l’épingle, avec Ctrl pour l’enregistrer, avec Ctrl+Maj pour l’élargir&#x202f;; Maj-clic en sélectionne d’autres</translation>
    </message>
    <message>
        <source>Drag to scale: the point becomes a small circle</source>
        <translation>Glissez pour mettre à l’échelle&#x202f;: le point devient un petit cercle</translation>
    </message>
    <message>
        <source>Drag to rotate: the point becomes a small circle, which holds its angle</source>
        <translation>Glissez pour faire pivoter&#x202f;: le point devient un petit cercle qui garde son angle</translation>
    </message>
</context>
<context>
    <name>Reasons</name>
    <message>
        <source>Choose one in the list first.</source>
        <translation>Choisissez d’abord un élément de la liste.</translation>
    </message>
</context>
<context>
    <name>Recording</name>
    <message>
        <source>%1 s</source>
        <translation>%1&#x202f;s</translation>
    </message>
    <message>
        <source>Recording until you let go; Esc cancels</source>
        <translation>Enregistré tel quel jusqu’à ce que vous lâchiez&#x202f;; Échap abandonne</translation>
    </message>
</context>
<context>
    <name>RegionTool</name>
    <message>
        <source>Drag from a point on the surface to hold a ball; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>Glissez depuis un point de la surface pour maintenir une sphère&#x202f;; Maj ajoute son contenu à la poignée sélectionnée, Ctrl le retire</translation>
    </message>
    <message>
        <source>Drag from a point on the surface towards the side to hold: all that lies beyond the point</source>
        <translation>Glissez depuis un point de la surface vers ce qu’il faut maintenir&#x202f;: tout ce qui est au-delà du point</translation>
    </message>
    <message>
        <source>Drag from a point on the surface to hold a box; Shift adds what is in it to the selected handle, Ctrl takes it away</source>
        <translation>Glissez depuis un point de la surface pour maintenir une boîte&#x202f;; Maj ajoute son contenu à la poignée sélectionnée, Ctrl le retire</translation>
    </message>
    <message>
        <source>There is no vertex in this region.</source>
        <translation>Il n’y a aucun sommet dans cette région.</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
</context>
<context>
    <name>SampleNames</name>
    <message>
        <source>back</source>
        <translation>dos</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>face</source>
        <translation>visage</translation>
    </message>
    <message>
        <source>far front hoof</source>
        <translation>sabot avant éloigné</translation>
    </message>
    <message>
        <source>far hind hoof</source>
        <translation>sabot arrière éloigné</translation>
    </message>
    <message>
        <source>front hoof</source>
        <translation>sabot avant</translation>
    </message>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
    <message>
        <source>hind hoof</source>
        <translation>sabot arrière</translation>
    </message>
    <message>
        <source>left elbow</source>
        <translation>coude gauche</translation>
    </message>
    <message>
        <source>left end</source>
        <translation>extrémité gauche</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>œil gauche</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>pied gauche</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>main gauche</translation>
    </message>
    <message>
        <source>left lower arm</source>
        <translation>bras inférieur gauche</translation>
    </message>
    <message>
        <source>left middle arm</source>
        <translation>bras médian gauche</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>bras supérieur gauche</translation>
    </message>
    <message>
        <source>left wing</source>
        <translation>aile gauche</translation>
    </message>
    <message>
        <source>right end</source>
        <translation>extrémité droite</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>œil droit</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>pied droit</translation>
    </message>
    <message>
        <source>right lower arm</source>
        <translation>bras inférieur droit</translation>
    </message>
    <message>
        <source>right middle arm</source>
        <translation>bras médian droit</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>bras supérieur droit</translation>
    </message>
    <message>
        <source>right wing</source>
        <translation>aile droite</translation>
    </message>
    <message>
        <source>rump</source>
        <translation>croupe</translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation>épaule</translation>
    </message>
    <message>
        <source>stiff</source>
        <translation>raide</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>queue</translation>
    </message>
    <message>
        <source>chest</source>
        <translation>poitrine</translation>
    </message>
    <message>
        <source>far hand</source>
        <translation>main éloignée</translation>
    </message>
    <message>
        <source>far heel</source>
        <translation>talon éloigné</translation>
    </message>
    <message>
        <source>far toe</source>
        <translation>pointe du pied éloigné</translation>
    </message>
    <message>
        <source>near hand</source>
        <translation>main proche</translation>
    </message>
    <message>
        <source>near heel</source>
        <translation>talon proche</translation>
    </message>
    <message>
        <source>near toe</source>
        <translation>pointe du pied proche</translation>
    </message>
    <message>
        <source>shadow</source>
        <translation>ombre</translation>
    </message>
</context>
<context>
    <name>SizeTool</name>
    <message>
        <source>Brush over what should be meshed finer; Shift makes it coarser, Ctrl evens it out again, [ and ] change the size</source>
        <translation>Passez le pinceau où le maillage doit être plus fin&#x202f;; Maj le rend plus grossier, Ctrl de nouveau uniforme, [ et ] changent la taille</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>Le maillage vient d’un fichier et sert tel quel.</translation>
    </message>
    <message>
        <source>Paint finer mesh</source>
        <translation>Maillage plus fin</translation>
    </message>
    <message>
        <source>Paint coarser mesh</source>
        <translation>Maillage plus grossier</translation>
    </message>
    <message>
        <source>Paint even mesh</source>
        <translation>Maillage uniforme</translation>
    </message>
</context>
<context>
    <name>StiffnessFields</name>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
</context>
<context>
    <name>StrokeTool</name>
    <message>
        <source>To the right: larger; up: harder. Esc leaves it as it was</source>
        <translation>Vers la droite&#x202f;: plus grand&#x202f;; vers le haut&#x202f;: plus dur. Échap le laisse tel quel</translation>
    </message>
    <message>
        <source>%1 px · %2 % hard</source>
        <translation>%1 px · dureté %2&#x202f;%</translation>
    </message>
</context>
<context>
    <name>Tools</name>
    <message>
        <source>&amp;Pin</source>
        <translation>É&amp;pingle</translation>
    </message>
    <message>
        <source>Set pins and drag them</source>
        <translation>Poser des épingles et les tirer</translation>
    </message>
    <message>
        <source>Se&amp;lect</source>
        <translation>Sé&amp;lection</translation>
    </message>
    <message>
        <source>Select and drag pins without setting new ones</source>
        <translation>Sélectionner et tirer des épingles sans en poser de nouvelles</translation>
    </message>
    <message>
        <source>Grab by &amp;Lasso</source>
        <translation>Saisir au la&amp;sso</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a drawn outline as one handle</source>
        <translation>Saisir en une seule poignée tout ce qui se trouve dans un contour tracé</translation>
    </message>
    <message>
        <source>Grab by Bo&amp;x</source>
        <translation>Saisir au &amp;rectangle</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a rectangle as one handle</source>
        <translation>Saisir en une seule poignée tout ce qui se trouve dans un rectangle</translation>
    </message>
    <message>
        <source>Grab by &amp;Brush</source>
        <translation>Saisir au pin&amp;ceau</translation>
    </message>
    <message>
        <source>Take hold of what is brushed over as one handle</source>
        <translation>Saisir en une seule poignée tout ce que parcourt le pinceau</translation>
    </message>
    <message>
        <source>Grab a B&amp;all</source>
        <translation>Saisir une sp&amp;hère</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a ball around a point on the surface</source>
        <translation>Saisir tout ce qui se trouve dans une sphère autour d’un point de la surface</translation>
    </message>
    <message>
        <source>Grab a Bloc&amp;k</source>
        <translation>Saisir une &amp;boîte</translation>
    </message>
    <message>
        <source>Take hold of all that lies in a block around a point on the surface</source>
        <translation>Saisir tout ce qui se trouve dans une boîte autour d’un point de la surface</translation>
    </message>
    <message>
        <source>Grab &amp;One Side</source>
        <translation>Saisir u&amp;n côté</translation>
    </message>
    <message>
        <source>Take hold of all that lies beyond a plane through a point on the surface</source>
        <translation>Saisir tout ce qui se trouve au-delà d’un plan passant par un point de la surface</translation>
    </message>
    <message>
        <source>Outline by &amp;Lasso</source>
        <translation>C&amp;ontour au lasso</translation>
    </message>
    <message>
        <source>Draw around what should bend, or should not</source>
        <translation>Entourer ce qui doit se déformer, ou non</translation>
    </message>
    <message>
        <source>Outline by &amp;Polygon</source>
        <translation>Contour au pol&amp;ygone</translation>
    </message>
    <message>
        <source>Set the corners of what should bend, or should not</source>
        <translation>Placer les coins de ce qui doit se déformer, ou non</translation>
    </message>
    <message>
        <source>Outline by &amp;Brush</source>
        <translation>Co&amp;ntour au pinceau</translation>
    </message>
    <message>
        <source>Brush over what should bend, or should not</source>
        <translation>Passer le pinceau sur ce qui doit se déformer, ou non</translation>
    </message>
    <message>
        <source>Click a colour that should bend, or should not</source>
        <translation>Cliquer sur une couleur qui doit se déformer, ou non</translation>
    </message>
    <message>
        <source>Cut &amp;Apart</source>
        <translation>Sép&amp;arer</translation>
    </message>
    <message>
        <source>Draw a line along which to part the shape</source>
        <translation>Tracer une ligne le long de laquelle séparer la forme</translation>
    </message>
    <message>
        <source>&amp;Detail Brush</source>
        <translation>Pinceau de déta&amp;il</translation>
    </message>
    <message>
        <source>Brush where the mesh should be finer or coarser</source>
        <translation>Peindre où le maillage doit être plus fin ou plus grossier</translation>
    </message>
    <message>
        <source>&amp;Paint</source>
        <translation>P&amp;eindre</translation>
    </message>
    <message>
        <source>Paint what is kept, or how stiff it is</source>
        <translation>Peindre ce qui est conservé, ou la raideur</translation>
    </message>
    <message>
        <source>&amp;Comb</source>
        <translation>Pei&amp;gner</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>Peigner la direction dans laquelle la forme est raide</translation>
    </message>
    <message>
        <source>&amp;Gradient</source>
        <translation>&amp;Dégradé</translation>
    </message>
    <message>
        <source>Drag to blend evenly from what is there to what is chosen</source>
        <translation>Glisser&#x202f;: ce qui s’y trouve passe progressivement à ce qui est choisi</translation>
    </message>
    <message>
        <source>&amp;Fill</source>
        <translation>Re&amp;mplir</translation>
    </message>
    <message>
        <source>Fill a connected area with what is chosen</source>
        <translation>Remplir de ce qui est choisi toute la zone contiguë</translation>
    </message>
    <message>
        <source>E&amp;yedropper</source>
        <translation>Pipe&amp;tte</translation>
    </message>
    <message>
        <source>Pick up what is painted under the pointer</source>
        <translation>Prélever ce qui est peint sous le pointeur</translation>
    </message>
    <message>
        <source>Depth Brus&amp;h</source>
        <translation>Pinceau de pro&amp;fondeur</translation>
    </message>
    <message>
        <source>Brush over what lies in front where the shape covers itself</source>
        <translation>Passer le pinceau sur ce qui est devant, là où la forme se recouvre</translation>
    </message>
    <message>
        <source>M&amp;easure</source>
        <translation>Mes&amp;urer</translation>
    </message>
    <message>
        <source>Measure lengths and angles between points of the shape</source>
        <translation>Mesurer longueurs et angles entre des points de la forme</translation>
    </message>
    <message>
        <source>E&amp;raser</source>
        <translation>&amp;Gomme</translation>
    </message>
    <message>
        <source>Erase paint: what you brush over is like the rest again</source>
        <translation>Retirer la peinture&#x202f;: ce que parcourt le pinceau redevient comme partout</translation>
    </message>
    <message>
        <source>&amp;Crop</source>
        <translation>&amp;Rogner</translation>
    </message>
    <message>
        <source>Draw a rectangle around the part of the picture that exports keep</source>
        <translation>Tracer un rectangle autour de ce que les exports gardent de l’image</translation>
    </message>
    <message>
        <source>Pe&amp;n</source>
        <translation>Plu&amp;me</translation>
    </message>
    <message>
        <source>Draw the path of a pin, point by point</source>
        <translation>Dessiner la trajectoire d’une épingle, point par point</translation>
    </message>
    <message>
        <source>Pa&amp;n</source>
        <translation>Déplacer la v&amp;ue</translation>
    </message>
    <message>
        <source>Drag the view to another place; in every step, holding the space bar does so, too</source>
        <translation>Tirer la vue ailleurs ; à chaque étape, la barre d’espace le fait</translation>
    </message>
    <message>
        <source>Magic &amp;Wand</source>
        <translation>&amp;Baguette magique</translation>
    </message>
</context>
<context>
    <name>wend::Actions</name>
    <message>
        <source>This picture is no SVG drawing: its pixels are what it has.</source>
        <translation>Cette image n’est pas un dessin SVG : ses pixels sont ce qu’elle a.</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ouvrir…</translation>
    </message>
    <message>
        <source>Open a picture, a mesh, a surface or a project</source>
        <translation>Ouvrir une image, un maillage, une surface ou un projet</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Save the project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>Save the project under another name</source>
        <translation>Enregistrer le projet sous un autre nom</translation>
    </message>
    <message>
        <source>&amp;Picture…</source>
        <translation>&amp;Image…</translation>
    </message>
    <message>
        <source>Write the bent picture at its full size</source>
        <translation>Exporter l’image telle qu’elle est déformée, en pleine taille</translation>
    </message>
    <message>
        <source>Ctrl+E</source>
        <translation>Ctrl+E</translation>
    </message>
    <message>
        <source>&amp;Sequence…</source>
        <translation>&amp;Séquence…</translation>
    </message>
    <message>
        <source>Write the motion as a sequence of pictures or meshes</source>
        <translation>Exporter le mouvement en séquence d’images ou de maillages</translation>
    </message>
    <message>
        <source>Ctrl+Shift+E</source>
        <translation>Ctrl+Shift+E</translation>
    </message>
    <message>
        <source>Write where each pixel comes from, for compositing programs</source>
        <translation>Exporter l’origine de chaque pixel, pour les logiciels de compositing</translation>
    </message>
    <message>
        <source>&amp;Mesh…</source>
        <translation>&amp;Maillage…</translation>
    </message>
    <message>
        <source>Write the bent mesh as OBJ, PLY, VTU …</source>
        <translation>Exporter le maillage déformé en OBJ, PLY, VTU…</translation>
    </message>
    <message>
        <source>&amp;View…</source>
        <translation>&amp;Vue…</translation>
    </message>
    <message>
        <source>Write the view as a picture, as large as you like</source>
        <translation>Exporter la vue en image, aussi grande que vous voulez</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>Ex&amp;porter</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Fermer</translation>
    </message>
    <message>
        <source>Close the file and go back to the start page</source>
        <translation>Fermer le fichier et revenir à la page d’accueil</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Leave Wend</source>
        <translation>Quitter Wend</translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation>Fichiers &amp;récents</translation>
    </message>
    <message>
        <source>Open Sa&amp;mple</source>
        <translation>Ouvrir un e&amp;xemple</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z</source>
        <translation>Ctrl+Shift+Z</translation>
    </message>
    <message>
        <source>Ctrl+Y</source>
        <translation>Ctrl+Y</translation>
    </message>
    <message>
        <source>Undo the last step</source>
        <translation>Annuler la dernière étape</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>Rétablir ce qui a été annulé</translation>
    </message>
    <message>
        <source>Ctrl+H</source>
        <translation>Ctrl+H</translation>
    </message>
    <message>
        <source>Select &amp;All Pins</source>
        <translation>Sélectionner &amp;toutes les épingles</translation>
    </message>
    <message>
        <source>Select all pins</source>
        <translation>Sélectionner toutes les épingles</translation>
    </message>
    <message>
        <source>Select &amp;None</source>
        <translation>&amp;Désélectionner tout</translation>
    </message>
    <message>
        <source>Select no pin</source>
        <translation>Ne sélectionner aucune épingle</translation>
    </message>
    <message>
        <source>Ctrl+Shift+A</source>
        <translation>Ctrl+Shift+A</translation>
    </message>
    <message>
        <source>&amp;Remove Pins</source>
        <translation>&amp;Supprimer les épingles</translation>
    </message>
    <message>
        <source>Remove the selected pins; what has already moved stays</source>
        <translation>Supprimer les épingles sélectionnées&#x202f;; ce qui a déjà bougé reste</translation>
    </message>
    <message>
        <source>M</source>
        <translation>M</translation>
    </message>
    <message>
        <source>Colour the shape by what changed</source>
        <translation>Colorer la forme selon ce qui a changé</translation>
    </message>
    <message>
        <source>D</source>
        <translation>D</translation>
    </message>
    <message>
        <source>&amp;Stiffness Marks</source>
        <translation>Marques de &amp;raideur</translation>
    </message>
    <message>
        <source>Show where the shape is stiff, and along which direction</source>
        <translation>Montrer où la forme est raide, et dans quelle direction</translation>
    </message>
    <message>
        <source>Shift+S</source>
        <translation>Shift+S</translation>
    </message>
    <message>
        <source>Show the bare picture; hold H to do so for a moment</source>
        <translation>Montrer l’image nue&#x202f;; maintenez H pour le faire un instant</translation>
    </message>
    <message>
        <source>Shift+H</source>
        <translation>Shift+H</translation>
    </message>
    <message>
        <source>&amp;Before</source>
        <translation>&amp;Voir l’original</translation>
    </message>
    <message>
        <source>Show the shape as it was before it was bent; hold \ to do so for a moment</source>
        <translation>Montrer la forme avant sa déformation&#x202f;; maintenez \ pour le faire un instant</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>A&amp;juster</translation>
    </message>
    <message>
        <source>Show the whole picture</source>
        <translation>Montrer l’image entière</translation>
    </message>
    <message>
        <source>F</source>
        <translation>F</translation>
    </message>
    <message>
        <source>&amp;Actual Size</source>
        <translation>Taille réell&amp;e</translation>
    </message>
    <message>
        <source>One pixel of the picture on one of the screen</source>
        <translation>Un pixel de l’image pour un pixel de l’écran</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>Zoom &amp;In</source>
        <translation>&amp;Zoom avant</translation>
    </message>
    <message>
        <source>Look closer</source>
        <translation>Voir de plus près</translation>
    </message>
    <message>
        <source>Zoom &amp;Out</source>
        <translation>Z&amp;oom arrière</translation>
    </message>
    <message>
        <source>See more</source>
        <translation>Voir plus large</translation>
    </message>
    <message>
        <source>Full &amp;Screen</source>
        <translation>&amp;Plein écran</translation>
    </message>
    <message>
        <source>Use the whole screen</source>
        <translation>Utiliser tout l’écran</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>Light or dark, like the desktop</source>
        <translation>Clair ou sombre comme le bureau</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Clair</translation>
    </message>
    <message>
        <source>Dark on light</source>
        <translation>Sombre sur clair</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Sombre</translation>
    </message>
    <message>
        <source>Light on dark</source>
        <translation>Clair sur sombre</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>&amp;Boucle</translation>
    </message>
    <message>
        <source>Start over at the end</source>
        <translation>Recommencer à la fin</translation>
    </message>
    <message>
        <source>Shift+L</source>
        <translation>Shift+L</translation>
    </message>
    <message>
        <source>To the &amp;Start</source>
        <translation>Au &amp;début</translation>
    </message>
    <message>
        <source>Show the shape at rest</source>
        <translation>Montrer la forme au repos</translation>
    </message>
    <message>
        <source>To the &amp;End</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>Show the end of the motion</source>
        <translation>Montrer la fin du mouvement</translation>
    </message>
    <message>
        <source>Let the shape relax at the end, with the pins where they are</source>
        <translation>Laisser la forme se détendre vers son repos à la fin, épingles en place</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>&amp;Manuel</translation>
    </message>
    <message>
        <source>How it works, page by page, with a search</source>
        <translation>Le fonctionnement, page par page, avec une recherche</translation>
    </message>
    <message>
        <source>&amp;Keys and Mouse</source>
        <translation>&amp;Clavier et souris</translation>
    </message>
    <message>
        <source>What the mouse and the keys do</source>
        <translation>Ce que font le pointeur et les touches</translation>
    </message>
    <message>
        <source>?</source>
        <translation>?</translation>
    </message>
    <message>
        <source>&amp;About Wend</source>
        <translation>À &amp;propos de Wend</translation>
    </message>
    <message>
        <source>Version and licence</source>
        <translation>Version et licence</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>A&amp;ppearance</source>
        <translation>Appare&amp;nce</translation>
    </message>
    <message>
        <source>&amp;Tools</source>
        <translation>&amp;Outils</translation>
    </message>
    <message>
        <source>&amp;Motion</source>
        <translation>&amp;Mouvement</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aid&amp;e</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Ouvrez d’abord une image.</translation>
    </message>
    <message>
        <source>A solid has no pixels.</source>
        <translation>Un solide n’a pas de pixels.</translation>
    </message>
    <message>
        <source>This project has no picture.</source>
        <translation>Ce projet n’a pas d’image.</translation>
    </message>
    <message>
        <source>A solid has no pixels: export the view.</source>
        <translation>Un solide n’a pas de pixels&#x202f;: exportez la vue.</translation>
    </message>
    <message>
        <source>For a picture, export the picture itself.</source>
        <translation>Pour une image, exportez l’image elle-même.</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Sélectionnez d’abord une épingle.</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>Rien ne bouge encore&#x202f;: tirez une épingle.</translation>
    </message>
    <message>
        <source>&amp;Tutorial</source>
        <translation>&amp;Tutoriel</translation>
    </message>
    <message>
        <source>The first five minutes, on a sample, step by step</source>
        <translation>Les cinq premières minutes, sur un exemple, pas à pas</translation>
    </message>
    <message>
        <source>&amp;Velocity Arrows</source>
        <translation>Flèches de vite&amp;sse</translation>
    </message>
    <message>
        <source>Show where the shape moves at this time</source>
        <translation>Montrer où va la forme à cet instant</translation>
    </message>
    <message>
        <source>Shift+V</source>
        <translation>Shift+V</translation>
    </message>
    <message>
        <source>&amp;Compare Energies</source>
        <translation>Comp&amp;arer les énergies</translation>
    </message>
    <message>
        <source>Show another energy side by side, with the same pins; or drag a tile of Keep onto the shape</source>
        <translation>Montrer à côté une autre énergie avec les mêmes épingles&#x202f;; ou glisser une vignette de Conserver sur la forme</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Enregi&amp;strer</translation>
    </message>
    <message>
        <source>Record every drag as it happens, in real time; Ctrl does so for one drag</source>
        <translation>Chaque geste est gardé tel quel, en temps réel&#x202f;; Ctrl le fait pour un seul</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>&amp;Onion Skin</source>
        <translation>Pelure d’&amp;oignon</translation>
    </message>
    <message>
        <source>Show the shape as it was a little before and as it is a little after</source>
        <translation>Montrer ce qui précède et ce qui suit de peu</translation>
    </message>
    <message>
        <source>Shift+N</source>
        <translation>Shift+N</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>How fast the motion plays, and how fast time goes while drags are recorded</source>
        <translation>La vitesse de lecture, et l’horloge des enregistrements</translation>
    </message>
    <message>
        <source>Speed: %1 %</source>
        <translation>Vitesse&#x202f;: %1&#x202f;%</translation>
    </message>
    <message>
        <source>Play or pause the motion; tapping the space bar does so, too</source>
        <translation>Lire le mouvement ou le mettre en pause&#x202f;; un appui bref sur la barre d’espace fait de même</translation>
    </message>
    <message>
        <source>&amp;Properties</source>
        <translation>&amp;Propriétés</translation>
    </message>
    <message>
        <source>Show the properties on the right, or give their room to the shape</source>
        <translation>Afficher les propriétés à droite, ou laisser leur place à la forme</translation>
    </message>
    <message>
        <source>Size of M&amp;arks</source>
        <translation>T&amp;aille des repères</translation>
    </message>
    <message>
        <source>How large pins, rings and curves are drawn, so that they are easy to see and to hit</source>
        <translation>La taille des épingles, anneaux et courbes sur la forme, pour l’œil et pour la main</translation>
    </message>
    <message>
        <source>Rela&amp;x</source>
        <translation>Dé&amp;tendre</translation>
    </message>
    <message>
        <source>ST &amp;Map…</source>
        <translation>Carte S&amp;T…</translation>
    </message>
    <message>
        <source>&amp;History…</source>
        <translation>&amp;Historique…</translation>
    </message>
    <message>
        <source>Show the undo history, and go back to any step</source>
        <translation>Afficher l’historique et revenir à n’importe quelle étape</translation>
    </message>
    <message>
        <source>&amp;Edges</source>
        <translation>A&amp;rêtes</translation>
    </message>
    <message>
        <source>Show the edges of the mesh</source>
        <translation>Afficher les arêtes du maillage</translation>
    </message>
    <message>
        <source>&amp;Colour Overlay</source>
        <translation>Incrustation &amp;couleur</translation>
    </message>
    <message>
        <source>&amp;Hide Pins and Overlays</source>
        <translation>Mas&amp;quer épingles et incrustations</translation>
    </message>
    <message>
        <source>&amp;Film…</source>
        <translation>&amp;Film…</translation>
    </message>
    <message>
        <source>Write the motion as a film: MP4, WebM, QuickTime, GIF …</source>
        <translation>Écrire le mouvement sous forme de film : MP4, WebM, QuickTime, GIF…</translation>
    </message>
    <message>
        <source>&amp;Pose at This Time</source>
        <translation>&amp;Pose à ce moment</translation>
    </message>
    <message>
        <source>In the step Animate, a drag sets where pins are at the time shown, and what they do before and after stays; off: it leads them on to the end of the film</source>
        <translation>À l’étape Animer, un glissement fixe où sont les épingles au temps affiché, et ce qu’elles font avant et après reste ; désactivé : il les mène jusqu’à la fin du film</translation>
    </message>
    <message>
        <source>Shift+T</source>
        <translation>Shift+T</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>Créer une &amp;partie</translation>
    </message>
    <message>
        <source>What is drawn as the outline becomes a part that bends by itself, or what you draw next; what is behind it is filled</source>
        <translation>Ce qui est dessiné comme contour, ou ce que vous dessinez ensuite, devient une partie qui se plie seule ; ce qui est derrière est rempli</translation>
    </message>
    <message>
        <source>Ctrl+J</source>
        <translation>Ctrl+J</translation>
    </message>
    <message>
        <source>Keep the Pa&amp;th</source>
        <translation>&amp;Garder le trajet</translation>
    </message>
    <message>
        <source>Re&amp;place Picture…</source>
        <translation>Rem&amp;placer l’image…</translation>
    </message>
    <message>
        <source>Bend another picture of the same proportions in the place of this one; pins and motions stay, and are scaled if it is larger or smaller</source>
        <translation>Déformer à sa place une autre image de mêmes proportions ; épingles et mouvements restent et sont mis à l’échelle si elle est plus grande ou plus petite</translation>
    </message>
    <message>
        <source>&amp;Apply Motion…</source>
        <translation>&amp;Appliquer un mouvement…</translation>
    </message>
    <message>
        <source>Move this shape as another project moves its own: pins of the same name, with lengths in proportion to the sizes of both shapes</source>
        <translation>Bouger cette forme comme un autre projet bouge la sienne : épingles de même nom, longueurs en proportion des tailles des deux formes</translation>
    </message>
    <message>
        <source>A drag that follows another of the same pins at the end of the film leads them on by a second; off: it corrects that move, which becomes straight</source>
        <translation>Un glissement qui suit un autre des mêmes épingles à la fin du film les mène une seconde plus loin ; désactivé : il corrige ce mouvement, qui devient droit</translation>
    </message>
    <message>
        <source>&amp;Keyboard Shortcuts…</source>
        <translation>Ra&amp;ccourcis clavier…</translation>
    </message>
    <message>
        <source>Give actions other keys</source>
        <translation>Donner d’autres touches aux commandes</translation>
    </message>
    <message>
        <source>&amp;Drawing Size…</source>
        <translation>Taille du &amp;dessin…</translation>
    </message>
    <message>
        <source>Draw the SVG drawing with more or fewer pixels; pins and motions are scaled with it</source>
        <translation>Dessiner le dessin SVG avec plus ou moins de pixels ; épingles et mouvements sont mis à l’échelle</translation>
    </message>
</context>
<context>
    <name>wend::BackdropChoice</name>
    <message>
        <source>Bac&amp;kdrop</source>
        <translation>&amp;Fond</translation>
    </message>
    <message>
        <source>&amp;Checks</source>
        <translation>&amp;Damier</translation>
    </message>
    <message>
        <source>Checks behind a picture, the workspace behind a solid</source>
        <translation>Un damier derrière une image, l’espace de travail derrière un solide</translation>
    </message>
    <message>
        <source>&amp;White</source>
        <translation>&amp;Blanc</translation>
    </message>
    <message>
        <source>White behind the shape, to see dark edges</source>
        <translation>Blanc derrière la forme&#x202f;: on y voit les bords sombres</translation>
    </message>
    <message>
        <source>&amp;Grey</source>
        <translation>&amp;Gris</translation>
    </message>
    <message>
        <source>Grey behind the shape</source>
        <translation>Gris derrière la forme</translation>
    </message>
    <message>
        <source>&amp;Black</source>
        <translation>&amp;Noir</translation>
    </message>
    <message>
        <source>Black behind the shape, to see light edges</source>
        <translation>Noir derrière la forme&#x202f;: on y voit les bords clairs</translation>
    </message>
</context>
<context>
    <name>wend::BalancePanel</name>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>Ce projet est lissé comme dans l’article, avec λ&#x202f;; son fichier dit de combien.</translation>
    </message>
</context>
<context>
    <name>wend::BrushActions</name>
    <message>
        <source>&amp;Brush</source>
        <translation>Pi&amp;nceau</translation>
    </message>
    <message>
        <source>Paint %1</source>
        <translation>Peindre %1</translation>
    </message>
    <message>
        <source>Choose the step “Paint” first.</source>
        <translation>Choisissez d’abord l’étape «&#x202f;Peindre&#x202f;».</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Conserver</translation>
    </message>
    <message>
        <source>Paint what the shape keeps when it has to give way</source>
        <translation>Peindre ce que la forme conserve quand elle doit céder</translation>
    </message>
    <message>
        <source>&amp;Stiffness</source>
        <translation>&amp;Raideur</translation>
    </message>
    <message>
        <source>Paint how many times stiffer the shape is along a direction</source>
        <translation>Peindre combien de fois la forme est plus raide dans une direction</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>&amp;Direction</translation>
    </message>
    <message>
        <source>Comb the direction along which the shape is stiff</source>
        <translation>Peigner la direction dans laquelle la forme est raide</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ], or by dragging to the right with Alt and the right button.</source>
        <translation>Le diamètre du pinceau à l’écran&#x202f;; aussi avec les touches [ et ], ou en glissant vers la droite avec Alt et le bouton droit.</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Dureté</translation>
    </message>
    <message>
        <source>How much of the brush paints fully; beyond that it fades out. Also by Shift with [ and ], or by dragging upwards with Alt and the right button.</source>
        <translation>La part du pinceau qui peint pleinement&#x202f;; au-delà, il s’estompe. Aussi avec Maj et [ ou ], ou en glissant vers le haut avec Alt et le bouton droit.</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Intensité</translation>
    </message>
    <message>
        <source>How far a stroke goes from what is there to what is painted.</source>
        <translation>De combien un trait rapproche ce qui est là de ce qui est peint.</translation>
    </message>
    <message>
        <source>&amp;Pressure</source>
        <translation>&amp;Pression</translation>
    </message>
    <message>
        <source>The harder a pen is pressed, the more of the amount is painted</source>
        <translation>Plus le stylet est appuyé, plus l’intensité peinte est forte</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>What you brush over lies in front if this is greater than 0, behind if it is less</source>
        <translation>Ce que parcourt le pinceau passe devant si l’ordre est supérieur à 0, derrière s’il est inférieur</translation>
    </message>
    <message>
        <source>Edges</source>
        <translation>Arêtes</translation>
    </message>
    <message>
        <source>How long the mesh&apos;s edges are where you brush, compared with elsewhere</source>
        <translation>Longueur des arêtes du maillage là où passe le pinceau, par rapport à ailleurs</translation>
    </message>
</context>
<context>
    <name>wend::CheatSheet</name>
    <message>
        <source>Keys and Mouse</source>
        <translation>Clavier et souris</translation>
    </message>
</context>
<context>
    <name>wend::CompareView</name>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>is being computed …</source>
        <translation>calcul en cours…</translation>
    </message>
    <message>
        <source>angle %1 · volume %2 · stretch %3</source>
        <translation>angle %1 · volume %2 · étirement %3</translation>
    </message>
    <message>
        <source>angle %1 · area %2 · stretch %3</source>
        <translation>angle %1 · aire %2 · étirement %3</translation>
    </message>
    <message>
        <source>The same with another energy</source>
        <translation>La même forme avec une autre énergie</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Comparer avec</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Terminer la comparaison</translation>
    </message>
    <message>
        <source>Shows one shape again.</source>
        <translation>Montre de nouveau une seule forme.</translation>
    </message>
    <message>
        <source>What this half keeps, or how it is without paint, with the same pins and motions.</source>
        <translation>Ce que cette moitié conserve, ou ce qu’elle est sans peinture, avec les mêmes épingles et mouvements.</translation>
    </message>
    <message>
        <source>Nothing painted</source>
        <translation>Rien de peint</translation>
    </message>
</context>
<context>
    <name>wend::CurveActions</name>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Courbe</translation>
    </message>
    <message>
        <source>Edit &amp;Path</source>
        <translation>Modifier la tra&amp;jectoire</translation>
    </message>
    <message>
        <source>Turn the last path of the selected pin into a Bézier curve</source>
        <translation>Convertir en courbe de Bézier la dernière trajectoire de l’épingle sélectionnée</translation>
    </message>
    <message>
        <source>Shift+C</source>
        <translation>Shift+C</translation>
    </message>
    <message>
        <source>&amp;Insert Point</source>
        <translation>&amp;Insérer un point</translation>
    </message>
    <message>
        <source>Split the curve at the pointer, or after the chosen point; its shape stays</source>
        <translation>Diviser la courbe à l’endroit pointé ou après le point choisi&#x202f;; sa forme reste</translation>
    </message>
    <message>
        <source>I</source>
        <translation>I</translation>
    </message>
    <message>
        <source>&amp;Delete Point</source>
        <translation>&amp;Supprimer le point</translation>
    </message>
    <message>
        <source>Remove the chosen point from the curve</source>
        <translation>Supprimer de la courbe le point choisi</translation>
    </message>
    <message>
        <source>Ctrl+Del</source>
        <translation>Ctrl+Del</translation>
    </message>
    <message>
        <source>&amp;Free</source>
        <translation>&amp;Libre</translation>
    </message>
    <message>
        <source>Let the two directions at the point be independent</source>
        <translation>Laisser chacune des deux directions du point suivre son chemin</translation>
    </message>
    <message>
        <source>Alt+1</source>
        <translation>Alt+1</translation>
    </message>
    <message>
        <source>&amp;Aligned</source>
        <translation>&amp;Aligné</translation>
    </message>
    <message>
        <source>Keep both directions at the point on one line</source>
        <translation>Garder les deux directions du point sur une même droite</translation>
    </message>
    <message>
        <source>Alt+2</source>
        <translation>Alt+2</translation>
    </message>
    <message>
        <source>A&amp;utomatic</source>
        <translation>A&amp;utomatique</translation>
    </message>
    <message>
        <source>Lead the curve smoothly through the point, guided by its neighbours</source>
        <translation>Faire passer la courbe en douceur par le point, d’après ses voisins</translation>
    </message>
    <message>
        <source>Alt+3</source>
        <translation>Alt+3</translation>
    </message>
    <message>
        <source>Select one pin that was dragged along a path.</source>
        <translation>Sélectionnez une épingle qui a été tirée le long d’une trajectoire.</translation>
    </message>
    <message>
        <source>Select one pin that follows a curve.</source>
        <translation>Sélectionnez une épingle qui suit une courbe.</translation>
    </message>
    <message>
        <source>Click a point of the curve first; two must remain.</source>
        <translation>Cliquez d’abord sur un point de la courbe&#x202f;; deux doivent rester.</translation>
    </message>
    <message>
        <source>Click an inner point of a Bézier curve first.</source>
        <translation>Cliquez d’abord sur un point intérieur d’une courbe de Bézier.</translation>
    </message>
</context>
<context>
    <name>wend::CurvePanel</name>
    <message>
        <source>Edit path</source>
        <translation>Modifier la trajectoire</translation>
    </message>
    <message>
        <source>Turns the drawn path into a Bézier curve with points to drag.</source>
        <translation>Convertit la trajectoire tracée en une courbe de Bézier avec des points à tirer.</translation>
    </message>
    <message>
        <source>no</source>
        <translation>non</translation>
    </message>
    <message>
        <source>as it bends (Frenet)</source>
        <translation>courbure (Frenet)</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>oui</translation>
    </message>
    <message>
        <source>Rotate with path</source>
        <translation>Auto-orientation</translation>
    </message>
    <message>
        <source>Whether what is held turns along the curve, and how.</source>
        <translation>Si ce qui est maintenu tourne en suivant la courbe, et comment.</translation>
    </message>
    <message>
        <source>Twist</source>
        <translation>Torsion</translation>
    </message>
    <message>
        <source>How far it turns around the curve&apos;s direction, over the whole curve.</source>
        <translation>Rotation autour de la direction de la courbe, sur toute sa longueur.</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>How large it has become at the end of the curve.</source>
        <translation>Taille atteinte à la fin de la courbe.</translation>
    </message>
    <message>
        <source>Rot&amp;ate with path</source>
        <translation>A&amp;uto-orientation</translation>
    </message>
    <message>
        <source>T&amp;wist</source>
        <translation>&amp;Torsion</translation>
    </message>
    <message>
        <source>S&amp;cale</source>
        <translation>É&amp;chelle</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow: hold more vertices.</source>
        <translation>Un point ne peut ni pivoter ni grandir&#x202f;: saisissez plus de sommets.</translation>
    </message>
    <message>
        <source>Change curve</source>
        <translation>Modifier la courbe</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>How the motion at the shown time starts and ends.</source>
        <translation>Comment le mouvement à l’instant affiché commence et finit.</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>Changer le lissage</translation>
    </message>
    <message>
        <source>A point cannot rotate or grow – drag its ring, or give it a radius.</source>
        <translation>Un point ne peut ni pivoter ni grandir – glissez son anneau, ou donnez-lui un rayon.</translation>
    </message>
</context>
<context>
    <name>wend::CutOutPanel</name>
    <message>
        <source>Only a cut-out has this. An outline that you have drawn stays as you drew it.</source>
        <translation>Seul un détourage a ce réglage. Un contour dessiné reste tel que vous l’avez dessiné.</translation>
    </message>
</context>
<context>
    <name>wend::CutPanel</name>
    <message>
        <source>Not cut</source>
        <translation>Sans coupe</translation>
    </message>
    <message>
        <source>Whole cells</source>
        <translation>Cellules entières</translation>
    </message>
    <message>
        <source>Exact</source>
        <translation>Exacte</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>Y</source>
        <translation>Y</translation>
    </message>
    <message>
        <source>Z</source>
        <translation>Z</translation>
    </message>
    <message>
        <source>Flip</source>
        <translation>Inverser</translation>
    </message>
    <message>
        <source>Cut across %1</source>
        <translation>Coupe perpendiculaire à %1</translation>
    </message>
    <message>
        <source>Other side</source>
        <translation>Autre côté</translation>
    </message>
    <message>
        <source>Turns the plane so that it is perpendicular to this axis.</source>
        <translation>Place le plan perpendiculairement à cet axe.</translation>
    </message>
    <message>
        <source>Cuts away the other side of the plane.</source>
        <translation>Retire l’autre côté du plan.</translation>
    </message>
    <message>
        <source>Place of the cut</source>
        <translation>Position de la coupe</translation>
    </message>
    <message>
        <source>Moves the plane through the solid.</source>
        <translation>Déplace le plan à travers le solide.</translation>
    </message>
    <message>
        <source>Normal of the cut</source>
        <translation>Normale de la coupe</translation>
    </message>
    <message>
        <source>The direction that the plane faces, as x, y and z.</source>
        <translation>Direction vers laquelle le plan est tourné, en x, y et z.</translation>
    </message>
    <message>
        <source>Distance of the cut</source>
        <translation>Distance de la coupe</translation>
    </message>
    <message>
        <source>How far the plane is from the origin, along its normal.</source>
        <translation>Distance du plan à l’origine, le long de sa normale.</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>&amp;Look inside</source>
        <translation>&amp;Intérieur</translation>
    </message>
    <message>
        <source>&amp;Distance</source>
        <translation>Dista&amp;nce</translation>
    </message>
    <message>
        <source>There is no solid to cut yet.</source>
        <translation>Il n’y a pas encore de solide à couper.</translation>
    </message>
    <message>
        <source>Looks inside: by whole tetrahedra, or along the exact plane.</source>
        <translation>Montre l’intérieur&#x202f;: par tétraèdres entiers ou le long du plan exact.</translation>
    </message>
</context>
<context>
    <name>wend::DepthActions</name>
    <message>
        <source>Bring to &amp;Front</source>
        <translation>Au &amp;premier plan</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies in front of all else</source>
        <translation>Là où la forme se recouvre, ce qui entoure les épingles sélectionnées passe devant tout le reste</translation>
    </message>
    <message>
        <source>Ctrl+Shift+]</source>
        <translation>Ctrl+Shift+]</translation>
    </message>
    <message>
        <source>Send to &amp;Back</source>
        <translation>À l’&amp;arrière-plan</translation>
    </message>
    <message>
        <source>Where the shape covers itself, what is around the selected pins lies behind all else</source>
        <translation>Là où la forme se recouvre, ce qui entoure les épingles sélectionnées passe derrière tout le reste</translation>
    </message>
    <message>
        <source>Ctrl+Shift+[</source>
        <translation>Ctrl+Shift+[</translation>
    </message>
    <message>
        <source>As &amp;Drawn</source>
        <translation>Comme &amp;dessiné</translation>
    </message>
    <message>
        <source>What is around the selected pins has no order of its own</source>
        <translation>Ce qui entoure les épingles sélectionnées n’a pas d’ordre propre</translation>
    </message>
    <message>
        <source>&amp;Number…</source>
        <translation>&amp;Nombre…</translation>
    </message>
    <message>
        <source>Give what is around the selected pins an order: the greater number lies in front</source>
        <translation>Donner un ordre à ce qui entoure les épingles sélectionnées&#x202f;: plus grand passe devant</translation>
    </message>
    <message>
        <source>&amp;Depth</source>
        <translation>Pr&amp;ofondeur</translation>
    </message>
    <message>
        <source>A solid has depth of its own.</source>
        <translation>Un solide a déjà sa profondeur.</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Sélectionnez d’abord une épingle.</translation>
    </message>
    <message>
        <source>Bring to front</source>
        <translation>Mettre au premier plan</translation>
    </message>
    <message>
        <source>Send to back</source>
        <translation>Mettre à l’arrière-plan</translation>
    </message>
    <message>
        <source>Depth as drawn</source>
        <translation>Profondeur d’origine</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Order (in front: greater than 0, behind: less):</source>
        <translation>Ordre (devant&#x202f;: supérieur à 0, derrière&#x202f;: inférieur)&#x202f;:</translation>
    </message>
</context>
<context>
    <name>wend::DetailChooser</name>
    <message>
        <source>Choose Skin</source>
        <translation>Choisir une peau</translation>
    </message>
    <message>
        <source>Surfaces (%1)</source>
        <translation>Surfaces (%1)</translation>
    </message>
    <message>
        <source>This surface cannot be embedded in the solid. %1</source>
        <translation>Cette surface ne peut pas suivre le solide. %1</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>Choisir une peau</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>Supprimer la peau</translation>
    </message>
</context>
<context>
    <name>wend::DistortionPanel</name>
    <message>
        <source>Go to the worst place</source>
        <translation>Aller au pire endroit</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Ce qui a changé</translation>
    </message>
    <message>
        <source>Colour &amp;by</source>
        <translation>Colore&amp;r par</translation>
    </message>
    <message>
        <source>Angle error</source>
        <translation>Erreur d’angle</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁/σ₂ + σ₂/σ₁ − 2: zero if all angles are kept.</source>
        <translation>Somme sur la forme de σ₁/σ₂ + σ₂/σ₁ − 2&#x202f;: zéro si tous les angles sont conservés.</translation>
    </message>
    <message>
        <source>Area error</source>
        <translation>Erreur d’aire</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirement</translation>
    </message>
    <message>
        <source>How far lengths are from those at rest: zero for a rigid motion.</source>
        <translation>Écart des longueurs par rapport au repos&#x202f;: zéro pour un mouvement rigide.</translation>
    </message>
    <message>
        <source>Worst place</source>
        <translation>Pire endroit</translation>
    </message>
    <message>
        <source>Volume error</source>
        <translation>Erreur de volume</translation>
    </message>
    <message>
        <source>Sum over the shape of det F + 1/det F − 2: zero if all volumes are kept.</source>
        <translation>Somme sur la forme de det F + 1/det F − 2&#x202f;: zéro si tous les volumes sont conservés.</translation>
    </message>
    <message>
        <source>Sum over the shape of σ₁σ₂ + 1/(σ₁σ₂) − 2: zero if all areas are kept.</source>
        <translation>Somme sur la forme de σ₁σ₂ + 1/(σ₁σ₂) − 2&#x202f;: zéro si toutes les aires sont conservées.</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Colorer par</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>O&amp;pacity</source>
        <translation>Opaci&amp;té</translation>
    </message>
    <message>
        <source>What is coloured over the solid: the error of lengths, volumes or angles, how far it is from where it was, the material, how fast it moves, or how fine its mesh is.</source>
        <translation>Ce qui est coloré sur le solide&#x202f;: l’erreur des longueurs, des volumes ou des angles, la distance à la place d’origine, le matériau, la vitesse du mouvement ou la finesse du maillage.</translation>
    </message>
    <message>
        <source>What is coloured over the picture: the error of lengths, areas or angles, how far it is from where it was, the material, or how fast it moves.</source>
        <translation>Ce qui est coloré sur l’image&#x202f;: l’erreur des longueurs, des aires ou des angles, la distance à la place d’origine, le matériau ou la vitesse du mouvement.</translation>
    </message>
    <message>
        <source>Smooth colo&amp;urs</source>
        <translation>Couleurs liss&amp;es</translation>
    </message>
    <message>
        <source>Blown up</source>
        <translation>Dégénérés</translation>
    </message>
    <message>
        <source>Passes through itself</source>
        <translation>Se traverse</translation>
    </message>
    <message>
        <source>Crosses itself</source>
        <translation>Se croise</translation>
    </message>
    <message>
        <source>nowhere</source>
        <translation>nulle part</translation>
    </message>
    <message>
        <source>1 place</source>
        <translation>1 endroit</translation>
    </message>
    <message numerus="yes">
        <source>%n places</source>
        <translation>
            <numerusform>%n endroit</numerusform>
            <numerusform>%n endroits</numerusform>
        </translation>
    </message>
    <message>
        <source>1 cell</source>
        <translation>1 cellule</translation>
    </message>
    <message numerus="yes">
        <source>%n cells</source>
        <translation>
            <numerusform>%n cellule</numerusform>
            <numerusform>%n cellules</numerusform>
        </translation>
    </message>
    <message>
        <source>This is checked once the pose is at rest.</source>
        <translation>La recherche se fait dès que la pose est au repos.</translation>
    </message>
    <message>
        <source>There is no such place.</source>
        <translation>Il n’y a pas de tel endroit.</translation>
    </message>
    <message>
        <source>No place is farther from rest than another.</source>
        <translation>Aucun endroit n’est plus loin du repos qu’un autre.</translation>
    </message>
    <message>
        <source>Pin error</source>
        <translation>Erreur d’épingle</translation>
    </message>
    <message>
        <source>How far the worst pin is from where it should be</source>
        <translation>Écart de la pire épingle par rapport à sa place</translation>
    </message>
    <message>
        <source>Computing time</source>
        <translation>Temps de calcul</translation>
    </message>
    <message>
        <source>How long the shown shape took to compute</source>
        <translation>Durée du calcul de la forme affichée</translation>
    </message>
    <message>
        <source>%1 px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Lock the scale</source>
        <translation>Verrouiller l’échelle</translation>
    </message>
    <message>
        <source>How much the overlay covers the picture, or the colours of the solid, below it.</source>
        <translation>Dans quelle mesure l’incrustation couvre l’image, ou les couleurs du solide, en dessous.</translation>
    </message>
    <message>
        <source>Blends the colours of the overlay from cell to cell. If off, each cell has the one colour of its value.</source>
        <translation>Fait passer les couleurs de l’incrustation progressivement d’une cellule à l’autre. Sinon, chaque cellule a la seule couleur de sa valeur.</translation>
    </message>
    <message>
        <source>Keeps the range of the colours, to compare different shapes and energies.</source>
        <translation>Garde la plage des couleurs, pour comparer des formes et des énergies.</translation>
    </message>
    <message>
        <source>Brings the most distorted triangle into view; it is ringed in the overlay.</source>
        <translation>Amène à l’écran le triangle le plus déformé ; l’incrustation l’entoure d’un anneau.</translation>
    </message>
    <message>
        <source>The tetrahedron that is farthest from rest in what the overlay shows.</source>
        <translation>Le tétraèdre le plus éloigné du repos selon ce que montre l’incrustation.</translation>
    </message>
    <message>
        <source>The triangle that is farthest from rest in what the overlay shows.</source>
        <translation>Le triangle le plus éloigné du repos selon ce que montre l’incrustation.</translation>
    </message>
    <message>
        <source>In how many places the surface passes through itself once the pose is at rest, each with its pairs of triangles. A click goes to the next one; the overlay marks them in red.</source>
        <translation>Combien de fois la surface se traverse une fois la pose au repos : des endroits, chacun fait de paires de triangles. Un clic montre le suivant ; l’incrustation les marque en rouge.</translation>
    </message>
    <message>
        <source>Where the outline crosses itself once the pose is at rest: one part lies over another. A click goes to the next one; the overlay marks them in red.</source>
        <translation>Où le contour se croise une fois la pose au repos : une partie en recouvre une autre. Un clic montre l’endroit suivant ; l’incrustation les marque en rouge.</translation>
    </message>
    <message>
        <source>Tetrahedra with more than ten times their volume, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>Tétraèdres de plus de dix fois leur volume, ou de moins d’un dixième. Un clic montre l’endroit suivant ; l’incrustation les marque en rouge.</translation>
    </message>
    <message>
        <source>Triangles with more than ten times their area, or less than a tenth of it. A click goes to the next place; the overlay marks them in red.</source>
        <translation>Triangles de plus de dix fois leur aire, ou de moins d’un dixième. Un clic montre l’endroit suivant ; l’incrustation les marque en rouge.</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmique</translation>
    </message>
    <message>
        <source>Colours from</source>
        <translation>Couleurs de</translation>
    </message>
    <message>
        <source>The value of the first colour. A typed value locks the scale; “≤” in the legend says that some places have less.</source>
        <translation>La valeur de la première couleur. Une valeur saisie fige l’échelle ; « ≤ » dans la légende dit que des endroits ont moins.</translation>
    </message>
    <message>
        <source>Colours to</source>
        <translation>Couleurs jusqu’à</translation>
    </message>
    <message>
        <source>The value of the last colour. A typed value locks the scale; “≥” in the legend says that some places have more.</source>
        <translation>La valeur de la dernière couleur. Une valeur saisie fige l’échelle ; « ≥ » dans la légende dit que des endroits ont plus.</translation>
    </message>
    <message>
        <source>Spreads the colours evenly over the orders of magnitude of the values.</source>
        <translation>Répartit les couleurs également sur les ordres de grandeur des valeurs.</translation>
    </message>
    <message>
        <source>Colours from, to</source>
        <translation>Couleurs de, à</translation>
    </message>
    <message>
        <source>These colours are those of the four energies.</source>
        <translation>Ces couleurs sont celles des quatre énergies.</translation>
    </message>
    <message>
        <source>The scale of this measure is fixed.</source>
        <translation>L’échelle de cette mesure est fixe.</translation>
    </message>
</context>
<context>
    <name>wend::DrawingSizeDialog</name>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Drawing Size</source>
        <translation>Taille du dessin</translation>
    </message>
    <message>
        <source>The drawing becomes a picture of this size. Pins, paths and regions are scaled with it; exported SVG files keep the drawing&apos;s own units.</source>
        <translation>Le dessin devient une image de cette taille. Épingles, trajectoires et régions sont mises à l’échelle ; les fichiers SVG exportés gardent les unités du dessin.</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Hauteur</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>&amp;Scale</source>
        <translation>É&amp;chelle</translation>
    </message>
    <message>
        <source>Of the size at which the drawing is opened</source>
        <translation>De la taille à laquelle le dessin est ouvert</translation>
    </message>
</context>
<context>
    <name>wend::EaseEditor</name>
    <message>
        <source>Easing Curve</source>
        <translation>Courbe de lissage</translation>
    </message>
    <message>
        <source>Speed at the &amp;start</source>
        <translation>Vitesse au &amp;début</translation>
    </message>
    <message>
        <source>Speed at the &amp;end</source>
        <translation>Vitesse à la &amp;fin</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>In percent of the speed of an even move: at 0 % the pin stops there.</source>
        <translation>En pourcentage de la vitesse d’un mouvement régulier : à 0 %, l’épingle s’y arrête.</translation>
    </message>
    <message>
        <source>Speed at the start</source>
        <translation>Vitesse au début</translation>
    </message>
    <message>
        <source>Speed at the end</source>
        <translation>Vitesse à la fin</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Tenir</translation>
    </message>
    <message>
        <source>The pin stays where it was, and goes on from there afterwards.</source>
        <translation>L’épingle reste où elle était, et repart de là ensuite.</translation>
    </message>
    <message>
        <source>Choose a bar or a key in the tracks.</source>
        <translation>Choisissez une barre ou une clé dans les pistes.</translation>
    </message>
    <message>
        <source>Rotations and scalings have one of the four easings.</source>
        <translation>Les rotations et mises à l’échelle ont l’un des quatre lissages.</translation>
    </message>
    <message>
        <source>1 motion</source>
        <translation>1 mouvement</translation>
    </message>
    <message numerus="yes">
        <source>%n motions</source>
        <translation>
            <numerusform>%n mouvement</numerusform>
            <numerusform>%n mouvements</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::EasePlot</name>
    <message>
        <source>Easing curve</source>
        <translation>Courbe de lissage</translation>
    </message>
    <message>
        <source>How far the pin has come over time. Drag the two handles up or down; Left and Right choose one, Up and Down move it.</source>
        <translation>Le chemin parcouru par l’épingle au fil du temps. Glissez les deux poignées vers le haut ou le bas ; Gauche et Droite en choisissent une, Haut et Bas la déplacent.</translation>
    </message>
</context>
<context>
    <name>wend::EnergySlider</name>
    <message>
        <source>What the shape keeps where it has to give way: from its volume, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>Ce que la forme conserve là où elle doit céder&#x202f;: de son volume, en passant par les longueurs et les parties rigides, à l’aspect de ses détails. Entre deux noms, c’est un peu des deux.</translation>
    </message>
    <message>
        <source>What the shape keeps where it has to give way: from its area, through lengths and rigid parts, to the look of its details. Between two names it is a mixture of both.</source>
        <translation>Ce que la forme conserve là où elle doit céder&#x202f;: de son aire, en passant par les longueurs et les parties rigides, à l’aspect de ses détails. Entre deux noms, c’est un peu des deux.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
</context>
<context>
    <name>wend::ExportDialog</name>
    <message>
        <source>Export Picture</source>
        <translation>Exporter l’image</translation>
    </message>
    <message>
        <source>Export Sequence</source>
        <translation>Exporter la séquence</translation>
    </message>
    <message>
        <source>Export ST Map</source>
        <translation>Exporter la carte ST</translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation>Exporter le maillage</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xporter…</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>Exporter le film</translation>
    </message>
</context>
<context>
    <name>wend::ExportForm</name>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>Le type de fichier à exporter.</translation>
    </message>
    <message>
        <source>Fit the Can&amp;vas</source>
        <translation>Adapter &amp;la toile</translation>
    </message>
    <message>
        <source>Fit the canvas</source>
        <translation>Adapter la toile</translation>
    </message>
    <message>
        <source>Make the canvas as large as the shape needs, so that nothing is cut off.</source>
        <translation>Donner à la toile la taille qu’il faut à la forme, pour que rien ne soit coupé.</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>Fo&amp;rmat</translation>
    </message>
    <message>
        <source>As in the picture</source>
        <translation>Comme dans l’image</translation>
    </message>
    <message>
        <source>As it suits the format best</source>
        <translation>Au mieux du format</translation>
    </message>
    <message>
        <source>%1 px on the left</source>
        <translation>%1 px à gauche</translation>
    </message>
    <message>
        <source>%1 px at the top</source>
        <translation>%1 px en haut</translation>
    </message>
    <message>
        <source>%1 px on the right</source>
        <translation>%1 px à droite</translation>
    </message>
    <message>
        <source>%1 px at the bottom</source>
        <translation>%1 px en bas</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>As it moves, the shape leaves the picture and is cut off there: %1.</source>
        <translation>En chemin, la forme sort de l’image et y est coupée&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The shape reaches beyond the picture and is cut off there: %1.</source>
        <translation>La forme dépasse de l’image et y est coupée&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 sommets</translation>
    </message>
    <message numerus="yes">
        <source>%n shapes of %1</source>
        <translation>
            <numerusform>%n forme de %1</numerusform>
            <numerusform>%n formes de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures of %1</source>
        <translation>
            <numerusform>%n image de %1</numerusform>
            <numerusform>%n images de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Cropped</source>
        <translation>Rognée</translation>
    </message>
    <message>
        <source>%1 has no transparency: pictures are placed on white.</source>
        <translation>%1 n’a pas de transparence : les images sont posées sur du blanc.</translation>
    </message>
</context>
<context>
    <name>wend::ExportPanel</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Sequence</source>
        <translation>Séquence</translation>
    </message>
    <message>
        <source>ST Map</source>
        <translation>ST map</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Choose a name and write what the preview shows.</source>
        <translation>Choisir un nom et écrire ce que montre l’aperçu.</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Exporter…</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
</context>
<context>
    <name>wend::ExportPreview</name>
    <message>
        <source>Preview</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>What will be written, smaller</source>
        <translation>Ce qui sera exporté, en plus petit</translation>
    </message>
</context>
<context>
    <name>wend::Exporter</name>
    <message>
        <source>Writing the picture …</source>
        <translation>Export de l’image…</translation>
    </message>
    <message numerus="yes">
        <source>Writing %n frames …</source>
        <translation>
            <numerusform>Export de %n image…</numerusform>
            <numerusform>Export de %n images…</numerusform>
        </translation>
    </message>
    <message>
        <source>Writing the mesh …</source>
        <translation>Export du maillage…</translation>
    </message>
    <message>
        <source>“%1” is this project itself. Replace it?</source>
        <translation>«&#x202f;%1&#x202f;» est ce projet lui-même. Le remplacer&#x202f;?</translation>
    </message>
    <message>
        <source>“%1” is the picture that this project bends. Replace it?</source>
        <translation>«&#x202f;%1&#x202f;» est l’image que ce projet déforme. La remplacer&#x202f;?</translation>
    </message>
    <message>
        <source>“%1” is the mesh that this project bends. Replace it?</source>
        <translation>«&#x202f;%1&#x202f;» est le maillage que ce projet déforme. Le remplacer&#x202f;?</translation>
    </message>
    <message>
        <source>“%1” belongs to this project. Replace it?</source>
        <translation>«&#x202f;%1&#x202f;» fait partie de ce projet. Le remplacer&#x202f;?</translation>
    </message>
    <message>
        <source>Another export is still being written. Try again in a moment.</source>
        <translation>Un autre export est encore en cours. Réessayez dans un instant.</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>La forme est encore en cours de calcul. Réessayez dans un instant.</translation>
    </message>
    <message>
        <source>There is no shape to export: it could not be computed.</source>
        <translation>Aucune forme à exporter&#x202f;: elle n’a pas pu être calculée.</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message numerus="yes">
        <source>Replace the frames that already exist (%n)?</source>
        <translation>
            <numerusform>%n de ces images existe déjà. La remplacer&#x202f;?</numerusform>
            <numerusform>%n de ces images existent déjà. Les remplacer&#x202f;?</numerusform>
        </translation>
    </message>
    <message>
        <source>What it holds now will be lost, and the project will no longer open as it is.</source>
        <translation>Son contenu actuel sera perdu, et le projet ne s’ouvrira plus tel qu’il est.</translation>
    </message>
    <message>
        <source>What they hold now will be lost.</source>
        <translation>Leur contenu actuel sera perdu.</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>Rien n’a été exporté. %1</translation>
    </message>
    <message>
        <source>Written without velocities: %1 (%2)</source>
        <translation>Exporté sans vitesses&#x202f;: %1 (%2)</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Exporté&#x202f;: %1</translation>
    </message>
    <message>
        <source>Export Material</source>
        <translation>Exporter le matériau</translation>
    </message>
    <message>
        <source>Pictures (*.png *.tif *.exr)</source>
        <translation>Images (*.png *.tif *.exr)</translation>
    </message>
    <message>
        <source>Writing the ST map …</source>
        <translation>Export de la carte ST…</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>Écriture du film…</translation>
    </message>
</context>
<context>
    <name>wend::FactsPanel</name>
    <message>
        <source>size</source>
        <translation>taille</translation>
    </message>
    <message>
        <source>area</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>triangles</translation>
    </message>
    <message>
        <source>edges</source>
        <translation>arêtes</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>mean edge</source>
        <translation>arête moyenne</translation>
    </message>
    <message>
        <source>parts</source>
        <translation>parties</translation>
    </message>
    <message>
        <source>boundary loops</source>
        <translation>boucles de bord</translation>
    </message>
    <message>
        <source>genus</source>
        <translation>genre</translation>
    </message>
    <message>
        <source>crossing pairs</source>
        <translation>paires qui se croisent</translation>
    </message>
    <message>
        <source>Worst cell</source>
        <translation>Pire cellule</translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation>Fente suivante</translation>
    </message>
    <message>
        <source>Open the widest</source>
        <translation>Ouvrir la plus large</translation>
    </message>
    <message>
        <source>Facts of the file</source>
        <translation>Données du fichier</translation>
    </message>
    <message>
        <source>The surface as it is in its file. Lengths are in the file&apos;s units, which few files name.</source>
        <translation>La surface telle que le fichier la donne. Les longueurs sont dans l&apos;unité du fichier, que peu indiquent.</translation>
    </message>
    <message>
        <source>Quality of the cells</source>
        <translation>Qualité des cellules</translation>
    </message>
    <message>
        <source>Circumradius over shortest edge of the worst tetrahedron, what was asked for, how many are above that, and how many triangles of the surface force them.</source>
        <translation>Rayon circonscrit sur arête la plus courte du pire tétraèdre, ce qui était demandé, combien le dépassent et combien de triangles de la surface les imposent.</translation>
    </message>
    <message>
        <source>Closed gaps</source>
        <translation>Fentes fermées</translation>
    </message>
    <message>
        <source>Gaps within one part that the cage closes: what lies on both sides moves together.</source>
        <translation>Fentes dans une même partie que la cage ferme&#x202f;: les deux côtés bougent ensemble.</translation>
    </message>
    <message>
        <source>Goes to the tetrahedron with the largest ratio.</source>
        <translation>Regarde le tétraèdre de plus grand rapport.</translation>
    </message>
    <message>
        <source>Goes through the gaps that the cage closes, one after another.</source>
        <translation>Regarde l&apos;une après l&apos;autre les fentes que la cage ferme.</translation>
    </message>
    <message>
        <source>Makes the cage so fine that the widest of these gaps stays open.</source>
        <translation>Affine la cage pour que la plus large de ces fentes reste ouverte.</translation>
    </message>
    <message>
        <source>Looking at the file …</source>
        <translation>Le fichier est examiné…</translation>
    </message>
    <message>
        <source>Surface of the file</source>
        <translation>Surface du fichier</translation>
    </message>
    <message>
        <source>worst ratio</source>
        <translation>pire rapport</translation>
    </message>
    <message>
        <source>asked for</source>
        <translation>demandé</translation>
    </message>
    <message>
        <source>cells above</source>
        <translation>cellules au-dessus</translation>
    </message>
    <message>
        <source>forced by triangles</source>
        <translation>imposé par des triangles</translation>
    </message>
    <message>
        <source>Tetrahedra</source>
        <translation>Tétraèdres</translation>
    </message>
    <message>
        <source>That would take more than a million vertices.</source>
        <translation>Il faudrait plus d&apos;un million de sommets.</translation>
    </message>
    <message>
        <source>Cage</source>
        <translation>Cage</translation>
    </message>
    <message>
        <source>closed gaps</source>
        <translation>fentes fermées</translation>
    </message>
    <message>
        <source>narrowest</source>
        <translation>la plus étroite</translation>
    </message>
    <message>
        <source>Open a gap</source>
        <translation>Ouvrir une fente</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>faces</translation>
    </message>
</context>
<context>
    <name>wend::FileCard</name>
    <message>
        <source>Sample: %1</source>
        <translation>Exemple&#x202f;: %1</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>Open the sample “%1”</source>
        <translation>Ouvrir l’exemple «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>%1, solid</source>
        <translation>%1, solide</translation>
    </message>
    <message>
        <source>Solid</source>
        <translation>Solide</translation>
    </message>
    <message>
        <source>Recover %1</source>
        <translation>Récupérer %1</translation>
    </message>
    <message>
        <source>Open the unsaved changes to “%1”</source>
        <translation>Ouvrir les modifications non enregistrées de «&#x202f;%1&#x202f;»</translation>
    </message>
</context>
<context>
    <name>wend::FileWorkflow</name>
    <message>
        <source>All that Wend opens (%1)</source>
        <translation>Tout ce que Wend ouvre (%1)</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>Projets (*.wend)</translation>
    </message>
    <message>
        <source>Meshes (%1)</source>
        <translation>Maillages (%1)</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>%1 has moved.</source>
        <translation>%1 a été déplacé.</translation>
    </message>
    <message>
        <source>Find It…</source>
        <translation>Localiser…</translation>
    </message>
    <message>
        <source>This file cannot be opened. %1</source>
        <translation>Impossible d’ouvrir ce fichier. %1</translation>
    </message>
    <message>
        <source>Nothing to see in this picture.</source>
        <translation>Rien de visible dans cette image.</translation>
    </message>
    <message>
        <source>Use Whole Frame</source>
        <translation>Toute l’image</translation>
    </message>
    <message>
        <source>Open Another…</source>
        <translation>En ouvrir une autre…</translation>
    </message>
    <message>
        <source>All files</source>
        <translation>Tous les fichiers</translation>
    </message>
    <message>
        <source>Find %1</source>
        <translation>Localiser %1</translation>
    </message>
    <message>
        <source>Your changes cannot be recovered if the program crashes: please save. %1</source>
        <translation>Il n’existe aucune copie de vos modifications en cas de plantage&#x202f;: enregistrez. %1</translation>
    </message>
    <message>
        <source>Wend</source>
        <translation>Wend</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>“%1” was changed by another program or window.</source>
        <translation>«&#x202f;%1&#x202f;» a été modifié par un autre programme ou une autre fenêtre.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Keep Mine</source>
        <translation>Garder le mien</translation>
    </message>
    <message>
        <source>Save As…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Reload “%1”?</source>
        <translation>Recharger «&#x202f;%1&#x202f;»&#x202f;?</translation>
    </message>
    <message>
        <source>Your changes since it was saved will be lost.</source>
        <translation>Vos modifications depuis l’enregistrement seront perdues.</translation>
    </message>
    <message>
        <source>Saving replaces those changes; reloading discards yours.</source>
        <translation>Enregistrer remplace ces modifications&#x202f;; recharger abandonne les vôtres.</translation>
    </message>
    <message>
        <source>The project was not saved: it needs the file “%1” itself. Choose another name.</source>
        <translation>Le projet n’a pas été enregistré&#x202f;: il a besoin du fichier «&#x202f;%1&#x202f;» lui-même. Choisissez un autre nom.</translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation>Enregistrer le projet</translation>
    </message>
    <message>
        <source>The project was not saved. %1</source>
        <translation>Le projet n’a pas été enregistré. %1</translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation>Enregistrer les modifications de «&#x202f;%1&#x202f;»&#x202f;?</translation>
    </message>
    <message>
        <source>If you do not save, they will be lost.</source>
        <translation>Sinon, elles seront perdues.</translation>
    </message>
    <message>
        <source>Wend was not closed properly: there are unsaved changes to “%1”.</source>
        <translation>Wend n’a pas été fermé correctement&#x202f;: il y a des modifications non enregistrées de «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Discard the unsaved changes to “%1”? They cannot be brought back.</source>
        <translation>Abandonner les modifications non enregistrées de «&#x202f;%1&#x202f;»&#x202f;? Elles seront perdues.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save what you made of “%1”?</source>
        <translation>Enregistrer ce que vous avez fait de « %1 » ?</translation>
    </message>
    <message>
        <source>It becomes a project of its own; the file stays as it is. If you do not save, what you made will be lost.</source>
        <translation>Cela devient un projet à part ; le fichier reste tel quel. Sans enregistrement, votre travail sera perdu.</translation>
    </message>
    <message>
        <source>“%1” %2.</source>
        <comment>a file, and what is wrong with it</comment>
        <translation>« %1 » %2.</translation>
    </message>
    <message>
        <source>Pictures with layers (%1)</source>
        <translation>Images avec calques (%1)</translation>
    </message>
</context>
<context>
    <name>wend::FilmPanel</name>
    <message>
        <source>Cycle</source>
        <translation>Cycle</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>Choose sound</source>
        <translation>Choisir le son</translation>
    </message>
    <message>
        <source>A file whose sound begins with the motion, and goes into MP4, WebM and QuickTime films.</source>
        <translation>Un fichier dont le son commence avec le mouvement et va dans les films MP4, WebM et QuickTime.</translation>
    </message>
    <message>
        <source>Remove sound</source>
        <translation>Retirer le son</translation>
    </message>
    <message>
        <source>The film has no sound then.</source>
        <translation>Le film n’a alors pas de son.</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Son</translation>
    </message>
    <message>
        <source>The part of the film that repeats, in seconds. A film that is exported as a loop shows it, and no picture twice.</source>
        <translation>La partie du film qui se répète, en secondes. Un film exporté en boucle la montre, sans image en double.</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>Changer le cycle</translation>
    </message>
    <message>
        <source>Choose Sound</source>
        <translation>Choisir le son</translation>
    </message>
    <message>
        <source>Sound and films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</source>
        <translation>Son et films (*.wav *.mp3 *.ogg *.oga *.opus *.flac *.m4a *.aac *.mp4 *.mov *.webm *.mkv)</translation>
    </message>
</context>
<context>
    <name>wend::FlowPanel</name>
    <message>
        <source>Relax</source>
        <translation>Détendre</translation>
    </message>
    <message>
        <source>The pins stay where they are, and what lies between them releases its tension. This takes one second at the end of the film.</source>
        <translation>Les épingles restent en place, et ce qui est entre elles relâche sa tension. Cela prend une seconde à la fin du film.</translation>
    </message>
    <message>
        <source>Springs back</source>
        <translation>Retour élastique</translation>
    </message>
    <message>
        <source>Nothing has moved yet.</source>
        <translation>Rien n’a encore bougé.</translation>
    </message>
    <message>
        <source>A shape that springs back fully is always relaxed.</source>
        <translation>Une forme qui revient entièrement est toujours détendue.</translation>
    </message>
</context>
<context>
    <name>wend::GroupList</name>
    <message>
        <source>Hold It</source>
        <translation>Le tenir</translation>
    </message>
    <message>
        <source>Groups of the file</source>
        <translation>Groupes du fichier</translation>
    </message>
    <message>
        <source>What the mesh&apos;s file calls by a name or number. A click marks a group on the shape; a double click, or Enter, pins it.</source>
        <translation>Ce que le fichier du maillage désigne par un nom ou un numéro. Un clic marque un groupe sur la forme ; un double clic, ou Entrée, l’épingle.</translation>
    </message>
    <message>
        <source>Hold the group</source>
        <translation>Tenir le groupe</translation>
    </message>
    <message>
        <source>Makes a pin of the chosen group, which the project names, so that it fits other meshes, too.</source>
        <translation>Fait une épingle du groupe choisi. Le projet retient son nom, si bien qu’elle convient aussi à d’autres maillages.</translation>
    </message>
    <message>
        <source>vertices</source>
        <translation>sommets</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>lignes</translation>
    </message>
    <message>
        <source>surfaces</source>
        <translation>surfaces</translation>
    </message>
    <message>
        <source>volumes</source>
        <translation>volumes</translation>
    </message>
    <message>
        <source>%1 (%2 %3)</source>
        <comment>name, number and kind of cells</comment>
        <translation>%1 (%2 %3)</translation>
    </message>
</context>
<context>
    <name>wend::HandlePanel</name>
    <message>
        <source>Select a pin to see its numbers.</source>
        <translation>Sélectionnez une épingle pour voir ses valeurs.</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Appliquer</translation>
    </message>
    <message>
        <source>Move by</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Rotate by</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Scale by</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Exact step</source>
        <translation>Pas exact</translation>
    </message>
    <message>
        <source>Moves, rotates or scales what is selected by exact numbers.</source>
        <translation>Déplace, fait pivoter ou met à l’échelle la sélection avec des valeurs exactes.</translation>
    </message>
    <message>
        <source>Amount</source>
        <translation>Valeur</translation>
    </message>
    <message>
        <source>How far along x, y and z; an angle; or a factor.</source>
        <translation>La distance en x, y et z, un angle ou un facteur.</translation>
    </message>
    <message>
        <source>around X</source>
        <translation>axe X</translation>
    </message>
    <message>
        <source>around Y</source>
        <translation>axe Y</translation>
    </message>
    <message>
        <source>around Z</source>
        <translation>axe Z</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>The axis of the rotation, through the middle of what is selected.</source>
        <translation>L’axe de rotation, passant par le milieu de la sélection.</translation>
    </message>
    <message>
        <source>Applies this step; it becomes part of the motion.</source>
        <translation>Exécute ce pas&#x202f;; il devient une partie du mouvement.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Épingle</translation>
    </message>
    <message>
        <source>at %1, %2, %3</source>
        <translation>à %1, %2, %3</translation>
    </message>
    <message>
        <source>at %1, %2</source>
        <translation>à %1&#x202f;; %2</translation>
    </message>
    <message>
        <source>does not hold now</source>
        <translation>ne tient pas maintenant</translation>
    </message>
</context>
<context>
    <name>wend::InfoBanner</name>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>wend::KeyPoseStrip</name>
    <message>
        <source>Key poses</source>
        <translation>Poses clés</translation>
    </message>
    <message>
        <source>The shape at the key poses of all pins: a click goes there</source>
        <translation>La forme aux poses clés de toutes les épingles : un clic y va</translation>
    </message>
    <message>
        <source>Key pose at %1</source>
        <translation>Pose clé : %1</translation>
    </message>
</context>
<context>
    <name>wend::LanguageChoice</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Langue</translation>
    </message>
    <message>
        <source>Like the &amp;Desktop</source>
        <translation>Comme le &amp;bureau</translation>
    </message>
    <message>
        <source>Speak the desktop&apos;s language, if Wend knows it</source>
        <translation>Parler la langue du bureau, si Wend la connaît</translation>
    </message>
    <message>
        <source>Speak %1</source>
        <translation>Parler %1</translation>
    </message>
    <message>
        <source>The language of the window, from the next start of Wend</source>
        <translation>La langue de la fenêtre, à partir du prochain démarrage de Wend</translation>
    </message>
    <message>
        <source>The language changes when Wend starts the next time.</source>
        <translation>La langue changera au prochain démarrage de Wend.</translation>
    </message>
</context>
<context>
    <name>wend::LayerPanel</name>
    <message>
        <source>The material is the same everywhere: brush over the shape to change a part.</source>
        <translation>C’est partout pareil&#x202f;: passez le pinceau sur la forme pour en changer une partie.</translation>
    </message>
    <message>
        <source>Each along a direction of its own.</source>
        <translation>Chacune selon sa propre direction.</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Haut</translation>
    </message>
    <message>
        <source>Lets the chosen layer win over the one above it.</source>
        <translation>Donne au calque choisi la priorité sur celui du dessus.</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Bas</translation>
    </message>
    <message>
        <source>Lets the layer below win over the chosen one.</source>
        <translation>Donne au calque du dessous la priorité sur celui choisi.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ôter</translation>
    </message>
    <message>
        <source>Removes the chosen layer.</source>
        <translation>Supprime le calque choisi.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>How many times stiffer the layer is along its direction; ×1 is the same as everywhere.</source>
        <translation>Combien de fois le calque est plus raide dans sa direction&#x202f;; ×1&#x202f;: comme partout.</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>Direction raide</translation>
    </message>
    <message>
        <source>At rest; it turns with the shape. A change is for all regions of the layer.</source>
        <translation>Au repos&#x202f;; elle tourne avec la forme. En changer vaut pour toutes les régions du calque.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Bord doux</translation>
    </message>
    <message>
        <source>How wide the edge fades, in the shape&apos;s own units.</source>
        <translation>Largeur sur laquelle le bord s’estompe, dans les unités de la forme.</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>&amp;Bord doux</translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation>Renommer le calque</translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation>Déplacer le calque</translation>
    </message>
    <message>
        <source>Remove layer</source>
        <translation>Supprimer le calque</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>Modifier le bord doux</translation>
    </message>
    <message>
        <source>Change layer</source>
        <translation>Modifier le calque</translation>
    </message>
    <message>
        <source>Unnamed</source>
        <translation>Sans nom</translation>
    </message>
    <message>
        <source>Where the material differs. The topmost layer wins; drag a layer to move it. A click shows its values, a double-click changes its name, its eye or the space bar switches it off.</source>
        <translation>Où le matériau est différent. Le calque du haut l’emporte&#x202f;: glissez un calque à sa place. Un clic montre ses valeurs, un double clic change son nom, son œil ou la barre d’espace le désactive.</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Imports the material from pictures made in a paint program, and exports it as such.</source>
        <translation>Importe le matériau depuis des images d’un logiciel de peinture, et l’exporte de même.</translation>
    </message>
    <message>
        <source>Read Again</source>
        <translation>Relire</translation>
    </message>
    <message>
        <source>Takes the pictures as they are now, after they have been saved in a paint program.</source>
        <translation>Reprend les images telles qu’elles sont à présent, une fois enregistrées dans un logiciel de peinture.</translation>
    </message>
    <message>
        <source>Read pictures again</source>
        <translation>Relire les images</translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation>Masquer le calque</translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation>Afficher le calque</translation>
    </message>
    <message>
        <source>Keep: %1</source>
        <translation>Conserver : %1</translation>
    </message>
    <message>
        <source>Stiffness: %1</source>
        <translation>Raideur&#x202f;: %1</translation>
    </message>
    <message>
        <source>Direction: %1</source>
        <translation>Direction&#x202f;: %1</translation>
    </message>
    <message>
        <source>As the project&apos;s file says, cell by cell.</source>
        <translation>Selon le fichier du projet, cellule par cellule.</translation>
    </message>
    <message>
        <source>Cell by cell: %1</source>
        <translation>Cellule par cellule&#x202f;: %1</translation>
    </message>
    <message>
        <source>Values of cells</source>
        <translation>Valeurs de cellules</translation>
    </message>
    <message>
        <source>&amp;Merge Down</source>
        <translation>&amp;Fusionner vers le bas</translation>
    </message>
    <message>
        <source>Makes one layer of the chosen one and the one below it</source>
        <translation>Réunit en un seul le calque choisi et celui du dessous</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Direction</translation>
    </message>
    <message>
        <source>Merge layers</source>
        <translation>Fusionner des calques</translation>
    </message>
    <message>
        <source>Stiffness ×1 has no direction: first choose how many times stiffer it is.</source>
        <translation>Une raideur de ×1 n’a pas de direction&#x202f;: choisissez d’abord combien de fois c’est plus raide.</translation>
    </message>
    <message>
        <source>What a file gives cell by cell stays lowest.</source>
        <translation>Ce qu’un fichier dit de chaque cellule reste tout en bas.</translation>
    </message>
    <message>
        <source>This is already the lowest layer.</source>
        <translation>C’est déjà le calque le plus bas.</translation>
    </message>
    <message>
        <source>This is already the topmost layer.</source>
        <translation>C’est déjà le calque le plus haut.</translation>
    </message>
    <message>
        <source>One of the two is switched off, is a picture, or erases.</source>
        <translation>L’un des deux est désactivé, est une image ou efface.</translation>
    </message>
    <message>
        <source>There is no layer below it.</source>
        <translation>Il n’y a pas de calque en dessous.</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>Re&amp;nommer</translation>
    </message>
    <message>
        <source>What a file says of each cell has no name.</source>
        <translation>Ce qu’un fichier dit de chaque cellule n’a pas de nom.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Whether the layer changes Keep, and to what.</source>
        <translation>Si le calque change ce qui est conservé, et en quoi.</translation>
    </message>
</context>
<context>
    <name>wend::Legend</name>
    <message>
        <source>Legend</source>
        <translation>Légende</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1&#x202f;: de %2 à %3</translation>
    </message>
</context>
<context>
    <name>wend::MainWindow</name>
    <message>
        <source>Main</source>
        <translation>Principale</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>%1[*] – Wend</source>
        <translation>%1[*] – Wend</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Plus</translation>
    </message>
    <message>
        <source>Let go to open “%1”</source>
        <translation>Relâchez pour ouvrir «&#x202f;%1&#x202f;»</translation>
    </message>
    <message numerus="yes">
        <source>Let go to open %n pictures as parts</source>
        <translation>
            <numerusform>Relâchez pour ouvrir %n image comme partie</numerusform>
            <numerusform>Relâchez pour ouvrir %n images comme parties</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>wend::ManualWindow</name>
    <message>
        <source>Manual</source>
        <translation>Manuel</translation>
    </message>
    <message>
        <source>Contents</source>
        <translation>Sommaire</translation>
    </message>
    <message>
        <source>The first page</source>
        <translation>La première page</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>The previous page</source>
        <translation>La page précédente</translation>
    </message>
    <message>
        <source>No page has these words.</source>
        <translation>Cela ne figure sur aucune page.</translation>
    </message>
    <message>
        <source>Search the manual</source>
        <translation>Chercher dans le manuel</translation>
    </message>
    <message>
        <source>Enter goes to the next place with these words, on this page or another.</source>
        <translation>Entrée va au prochain endroit où figurent ces mots, sur cette page ou une autre.</translation>
    </message>
</context>
<context>
    <name>wend::MaterialActions</name>
    <message>
        <source>A grey picture over the whole, as a layer: black keeps area, white keeps angles</source>
        <translation>Une image grise sur le tout, comme calque&#x202f;: le noir conserve l’aire, le blanc les angles</translation>
    </message>
    <message>
        <source>Import &amp;Stiffness…</source>
        <translation>Importer la &amp;raideur…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer: black is the same as everywhere, white is 1000 times stiffer</source>
        <translation>Une image grise sur le tout, comme calque&#x202f;: noir comme partout, blanc 1000 fois plus raide</translation>
    </message>
    <message>
        <source>Import &amp;Directions…</source>
        <translation>Importer les &amp;directions…</translation>
    </message>
    <message>
        <source>A grey picture over the whole, as a layer, of the direction of stiffness: black is level, middle grey upright</source>
        <translation>Une image grise sur le tout, comme calque&#x202f;: noir horizontal, gris moyen vertical&#x202f;; ce qui est raide l’est dans cette direction</translation>
    </message>
    <message>
        <source>Import Values of &amp;Cells…</source>
        <translation>Importer des valeurs de c&amp;ellules…</translation>
    </message>
    <message>
        <source>φ and B of every cell from a mesh file that contains them, such as an exported one</source>
        <translation>φ et B de chaque cellule depuis un fichier de maillage qui les contient, par exemple un maillage exporté</translation>
    </message>
    <message>
        <source>As a grey picture, to be edited in a paint program</source>
        <translation>En image grise, à poursuivre dans un logiciel de peinture</translation>
    </message>
    <message>
        <source>Export S&amp;tiffness…</source>
        <translation>Exporter la r&amp;aideur…</translation>
    </message>
    <message>
        <source>Export Di&amp;rections…</source>
        <translation>Exporter les d&amp;irections…</translation>
    </message>
    <message>
        <source>&amp;Material</source>
        <translation>&amp;Matériau</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Ouvrez d’abord une image.</translation>
    </message>
    <message>
        <source>For a solid, these are values of cells; they are exported with its mesh.</source>
        <translation>Pour un solide, ce sont des valeurs de cellules&#x202f;; elles s’exportent avec son maillage.</translation>
    </message>
    <message>
        <source>Only the cells of a mesh file stay the same.</source>
        <translation>Seules les cellules d’un fichier de maillage restent les mêmes.</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message>
        <source>Import %1</source>
        <translation>Importer %1</translation>
    </message>
    <message>
        <source>Values of cells (*.vtu *.vtk *.json)</source>
        <translation>Valeurs de cellules (*.vtu *.vtk *.json)</translation>
    </message>
    <message>
        <source>The layers were switched off: what was imported lies below them.</source>
        <translation>Les calques sont désactivés&#x202f;: ce qui est importé se trouve en dessous.</translation>
    </message>
    <message>
        <source>Import &amp;Keep…</source>
        <translation>Importer &amp;Conserver…</translation>
    </message>
    <message>
        <source>Export K&amp;eep…</source>
        <translation>Exporter Cons&amp;erver…</translation>
    </message>
</context>
<context>
    <name>wend::MaterialPanel</name>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Between %1 and %2.</source>
        <translation>Entre %1 et %2.</translation>
    </message>
    <message>
        <source>Grown ×%1 – try %2</source>
        <translation>Agrandi ×%1 – essayez %2</translation>
    </message>
    <message>
        <source>The shape has become much larger than at rest. A click keeps more of its size.</source>
        <translation>La forme est devenue bien plus grande qu’au repos. Un clic conserve mieux sa taille.</translation>
    </message>
    <message>
        <source>Whole shape</source>
        <translation>Forme entière</translation>
    </message>
    <message>
        <source>Keep: whole shape</source>
        <translation>Conserver : toute la forme</translation>
    </message>
</context>
<context>
    <name>wend::MeasurePanel</name>
    <message>
        <source>Measures</source>
        <translation>Mesures</translation>
    </message>
    <message>
        <source>Size of the solid</source>
        <translation>Taille du solide</translation>
    </message>
    <message>
        <source>Volume and area of the surface, now and at rest.</source>
        <translation>Volume et aire de la surface, maintenant et au repos.</translation>
    </message>
    <message>
        <source>Size of what is selected</source>
        <translation>Taille de la sélection</translation>
    </message>
    <message>
        <source>Volume of the tetrahedra and area of the outer triangles that the selected handles hold.</source>
        <translation>Volume des tétraèdres et aire des triangles extérieurs que maintiennent les poignées sélectionnées.</translation>
    </message>
    <message>
        <source>Vertex under the pointer</source>
        <translation>Sommet sous le pointeur</translation>
    </message>
    <message>
        <source>The nearest vertex and where it is.</source>
        <translation>Le sommet le plus proche et sa position.</translation>
    </message>
    <message>
        <source>Tetrahedron under the pointer</source>
        <translation>Tétraèdre sous le pointeur</translation>
    </message>
    <message>
        <source>All values of the tetrahedron.</source>
        <translation>Toutes les valeurs du tétraèdre.</translation>
    </message>
    <message>
        <source>%1, at rest %2</source>
        <translation>%1, au repos %2</translation>
    </message>
    <message>
        <source>volume</source>
        <translation>volume</translation>
    </message>
    <message>
        <source>area</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>The whole</source>
        <translation>Solide entier</translation>
    </message>
    <message numerus="yes">
        <source>Selected vertices: %n</source>
        <translation>
            <numerusform>Sélection&#x202f;: %n sommet</numerusform>
            <numerusform>Sélection&#x202f;: %n sommets</numerusform>
        </translation>
    </message>
    <message>
        <source>Point at the solid to see the values there.</source>
        <translation>Pointez le solide pour y voir les valeurs.</translation>
    </message>
    <message>
        <source>Vertex %1</source>
        <translation>Sommet %1</translation>
    </message>
    <message>
        <source>place</source>
        <translation>position</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>pointed at</source>
        <translation>point visé</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>vitesse</translation>
    </message>
    <message>
        <source>dihedral angles</source>
        <translation>angles dièdres</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>circumradius to shortest edge</source>
        <translation>rayon circonscrit / plus petite arête</translation>
    </message>
    <message>
        <source>Tetrahedron %1</source>
        <translation>Tétraèdre %1</translation>
    </message>
</context>
<context>
    <name>wend::MemorySlider</name>
    <message>
        <source>not at all</source>
        <translation>nulle</translation>
    </message>
    <message>
        <source>fully</source>
        <translation>totale</translation>
    </message>
</context>
<context>
    <name>wend::MeshPanel</name>
    <message>
        <source>Vertices</source>
        <translation>Sommets</translation>
    </message>
    <message>
        <source>Maximum volume</source>
        <translation>Volume maximal</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Cible</translation>
    </message>
    <message>
        <source>What sets how fine the mesh is: how many vertices it has in total, or how large a tetrahedron may be.</source>
        <translation>Ce qui détermine la finesse du maillage&#x202f;: son nombre total de sommets, ou la taille que peut avoir un tétraèdre.</translation>
    </message>
    <message>
        <source>Paint…</source>
        <translation>Peindre…</translation>
    </message>
    <message>
        <source>Cell sizes</source>
        <translation>Tailles de cellule</translation>
    </message>
    <message>
        <source>Paints where the mesh should be finer or coarser, or sets it by regions in numbers.</source>
        <translation>Peint où le maillage doit être plus fin ou plus grossier, ou l’indique en nombres, par régions.</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>A&amp;im at</source>
        <translation>&amp;Cible</translation>
    </message>
    <message>
        <source>Detail: coarse – fine</source>
        <translation>Détail&#x202f;: grossier – fin</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>Plus fin ou grossier</translation>
    </message>
    <message>
        <source>Aim at a volume</source>
        <translation>Cible&#x202f;: volume</translation>
    </message>
    <message>
        <source>Aim at vertices</source>
        <translation>Cible&#x202f;: sommets</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>Le maillage vient d’un fichier et sert tel quel.</translation>
    </message>
    <message>
        <source>This picture has no transparency.</source>
        <translation>Cette image n’a pas de transparence.</translation>
    </message>
    <message>
        <source>No outline has been drawn.</source>
        <translation>Aucun contour n’a été tracé.</translation>
    </message>
    <message>
        <source>%1 vertices, %2 tetrahedra</source>
        <translation>%1 sommets, %2 tétraèdres</translation>
    </message>
    <message>
        <source>%1 vertices, %2 triangles</source>
        <translation>%1 sommets, %2 triangles</translation>
    </message>
    <message>
        <source>Outline and detail of</source>
        <translation>Contour et détail de</translation>
    </message>
    <message>
        <source>Which part of the picture has the outline and detail below; all have the same unless one has its own. Choosing a part in the list of parts chooses it here.</source>
        <translation>La partie de l’image qui a le contour et le détail ci-dessous&#x202f;; toutes ont les mêmes, sauf celles qui ont les leurs. Une partie choisie dans la liste des parties l’est aussi ici.</translation>
    </message>
    <message>
        <source>As All Parts</source>
        <translation>Comme toutes les parties</translation>
    </message>
    <message>
        <source>Gives this part the outline and detail of all parts again.</source>
        <translation>Redonne à cette partie le contour et le détail de toutes.</translation>
    </message>
    <message>
        <source>&amp;Of</source>
        <translation>D&amp;e</translation>
    </message>
    <message>
        <source>All parts</source>
        <translation>Toutes les parties</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Choisir…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Choose skin</source>
        <translation>Choisir une peau</translation>
    </message>
    <message>
        <source>Takes a detailed, perhaps textured surface from a file and embeds it in the solid; the view shows it, and surface formats contain it.</source>
        <translation>Prend dans un fichier une surface détaillée, éventuellement texturée&#x202f;: elle suit le solide, c’est elle que montre la vue et que reçoivent les formats de surface.</translation>
    </message>
    <message>
        <source>Remove skin</source>
        <translation>Supprimer la peau</translation>
    </message>
    <message>
        <source>Shows and exports the solid with its own surface again.</source>
        <translation>Le solide est de nouveau affiché et exporté avec sa propre surface.</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>Peau</translation>
    </message>
</context>
<context>
    <name>wend::ModeRow</name>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>How large the picture is shown; a click shows its pixels as they are.</source>
        <translation>La taille à laquelle l’image est vue ; un clic montre ses pixels tels quels.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Export what is shown as a picture, film, sequence, ST map, mesh or view</source>
        <translation>Exporter ce qui est affiché&#x202f;: image, film, séquence, ST map, maillage ou vue</translation>
    </message>
</context>
<context>
    <name>wend::MotionChooser</name>
    <message>
        <source>Apply Motion of Another Project</source>
        <translation>Appliquer le mouvement d’un autre projet</translation>
    </message>
    <message>
        <source>Projects (*.wend)</source>
        <translation>Projets (*.wend)</translation>
    </message>
    <message>
        <source>This motion cannot be applied. %1</source>
        <translation>Ce mouvement ne peut pas être appliqué. %1</translation>
    </message>
    <message>
        <source>Apply motion of %1</source>
        <translation>Appliquer le mouvement de %1</translation>
    </message>
</context>
<context>
    <name>wend::Offers</name>
    <message>
        <source>This picture fills its frame. If its border is held, it bends inside and no gap opens at the edges.</source>
        <translation>Cette image remplit son cadre. Le bord maintenu, elle se déforme à l’intérieur, sans vide sur les côtés.</translation>
    </message>
    <message>
        <source>Hold the Border</source>
        <translation>Maintenir le bord</translation>
    </message>
    <message>
        <source>Soft edges or shadows of this picture reach beyond the cut-out, and are cut off.</source>
        <translation>Des bords doux ou des ombres de cette image dépassent du détourage et sont coupés.</translation>
    </message>
    <message>
        <source>Include Them</source>
        <translation>Les inclure</translation>
    </message>
    <message>
        <source>This picture is mostly thin lines, and only the lines would bend. Filled holes bend what they enclose, too.</source>
        <translation>Cette image est surtout faite de traits fins, et seuls les traits se plieraient. Avec les trous remplis, ce qu’ils entourent se plie aussi.</translation>
    </message>
    <message>
        <source>Fill the Holes</source>
        <translation>Remplir les trous</translation>
    </message>
    <message numerus="yes">
        <source>%n pictures were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n image a été ouverte comme partie : elle se plie seule.</numerusform>
            <numerusform>%n images ont été ouvertes comme parties : chacune se plie seule. Joignez-les là où elles se touchent, sous Parties.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n layers were opened as parts: each bends by itself. Join them where they meet, under Parts.</source>
        <translation>
            <numerusform>%n calque a été ouvert comme partie : il se plie seul.</numerusform>
            <numerusform>%n calques ont été ouverts comme parties : chacune se plie seule. Joignez-les là où elles se touchent, sous Parties.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open Flattened</source>
        <translation>Ouvrir aplatie</translation>
    </message>
    <message>
        <source>Open flattened</source>
        <translation>Ouvrir aplatie</translation>
    </message>
    <message>
        <source>Another Size…</source>
        <translation>Autre taille…</translation>
    </message>
    <message>
        <source>This drawing became a picture of %1 × %2 pixels.</source>
        <translation>Ce dessin est devenu une image de %1 × %2 pixels.</translation>
    </message>
</context>
<context>
    <name>wend::OpeningNote</name>
    <message>
        <source>Opening %1 …</source>
        <translation>Ouverture de %1…</translation>
    </message>
</context>
<context>
    <name>wend::OptionRow</name>
    <message>
        <source>Options</source>
        <translation>Options</translation>
    </message>
</context>
<context>
    <name>wend::PaintPanel</name>
    <message>
        <source>How many times stiffer the painted part is along its direction; ×1 is the same as everywhere.</source>
        <translation>Combien de fois la partie peinte est plus raide dans sa direction&#x202f;; ×1&#x202f;: comme partout.</translation>
    </message>
    <message>
        <source>Stiff direction</source>
        <translation>Direction raide</translation>
    </message>
    <message>
        <source>The direction at rest, which turns with the shape: the stroke&apos;s own, the one that is there, an axis, numbers, or the path of the selected pin where it is nearest.</source>
        <translation>La direction au repos, qui tourne avec la forme&#x202f;: celle du trait, celle qui est déjà là, un axe, des nombres, ou la trajectoire de l’épingle sélectionnée là où elle est le plus proche.</translation>
    </message>
    <message>
        <source>Direction in numbers</source>
        <translation>Direction en nombres</translation>
    </message>
    <message>
        <source>At rest; its length does not matter.</source>
        <translation>Au repos&#x202f;; sa longueur n’importe pas.</translation>
    </message>
    <message>
        <source>St&amp;iffness</source>
        <translation>Ra&amp;ideur</translation>
    </message>
    <message>
        <source>Di&amp;rection</source>
        <translation>Dire&amp;ction</translation>
    </message>
    <message>
        <source>along the stroke</source>
        <translation>selon le trait</translation>
    </message>
    <message>
        <source>as it is there</source>
        <translation>telle qu’elle est</translation>
    </message>
    <message>
        <source>along X</source>
        <translation>selon X</translation>
    </message>
    <message>
        <source>along Y</source>
        <translation>selon Y</translation>
    </message>
    <message>
        <source>along Z</source>
        <translation>selon Z</translation>
    </message>
    <message>
        <source>as numbers</source>
        <translation>en nombres</translation>
    </message>
    <message>
        <source>along the view</source>
        <translation>selon la vue</translation>
    </message>
    <message>
        <source>along the pin&apos;s path</source>
        <translation>selon l’épingle</translation>
    </message>
    <message>
        <source>What the brush paints</source>
        <translation>Ce que peint le pinceau</translation>
    </message>
    <message>
        <source>The brush paints</source>
        <translation>Le pinceau peint</translation>
    </message>
</context>
<context>
    <name>wend::PartList</name>
    <message>
        <source>Joint x</source>
        <translation>Articulation x</translation>
    </message>
    <message>
        <source>Joint y</source>
        <translation>Articulation y</translation>
    </message>
    <message>
        <source>Move joint</source>
        <translation>Déplacer l’articulation</translation>
    </message>
    <message>
        <source>Where the part turns at rest, in pixels from the upper left corner: a point in both parts, marked by a ring on the picture.</source>
        <translation>Où la partie tourne au repos, en pixels depuis le coin supérieur gauche : un point des deux parties, marqué d’un anneau sur l’image.</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>masquée</translation>
    </message>
    <message>
        <source>rides on %1</source>
        <translation>suit %1</translation>
    </message>
    <message>
        <source>joined to %1</source>
        <translation>jointe à %1</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Opac&amp;ity</source>
        <translation>Opac&amp;ité</translation>
    </message>
    <message>
        <source>&amp;Joined to</source>
        <translation>&amp;Jointe à</translation>
    </message>
    <message>
        <source>&amp;Rides on</source>
        <translation>&amp;Suit</translation>
    </message>
    <message>
        <source>Parts of the picture</source>
        <translation>Parties de l’image</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>En avant</translation>
    </message>
    <message>
        <source>Brings the part in front of the next one (Alt+Up).</source>
        <translation>Place la partie devant la suivante (Alt+Haut).</translation>
    </message>
    <message>
        <source>Backward</source>
        <translation>En arrière</translation>
    </message>
    <message>
        <source>Brings the part behind the next one (Alt+Down).</source>
        <translation>Place la partie derrière la suivante (Alt+Bas).</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>How much is seen of the part.</source>
        <translation>Ce que l’on voit de la partie.</translation>
    </message>
    <message>
        <source>Joined to</source>
        <translation>Jointe à</translation>
    </message>
    <message>
        <source>Welds the part to another one in the middle of where they overlap at rest: it turns there, and pulls nothing else.</source>
        <translation>Joint la partie à une autre au milieu de leur recouvrement au repos : elle y tourne et n’entraîne rien d’autre.</translation>
    </message>
    <message>
        <source>Rides on</source>
        <translation>Suit</translation>
    </message>
    <message>
        <source>The part follows the motion of another one, as eyes do on a face.</source>
        <translation>La partie suit le mouvement d’une autre, comme les yeux sur un visage.</translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation>Changer l’opacité</translation>
    </message>
    <message>
        <source>Choose a part that is not in front.</source>
        <translation>Choisissez une partie qui n’est pas tout devant.</translation>
    </message>
    <message>
        <source>Choose a part that is not at the back.</source>
        <translation>Choisissez une partie qui n’est pas tout au fond.</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Hide part</source>
        <translation>Masquer la partie</translation>
    </message>
    <message>
        <source>Show part</source>
        <translation>Afficher la partie</translation>
    </message>
    <message>
        <source>Another part has this name.</source>
        <translation>Une autre partie porte ce nom.</translation>
    </message>
    <message>
        <source>Rename part</source>
        <translation>Renommer la partie</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Changer l’ordre</translation>
    </message>
    <message>
        <source>These parts do not overlap at rest: there is no place for a joint.</source>
        <translation>Ces parties ne se recouvrent pas au repos : il n’y a pas de place pour une articulation.</translation>
    </message>
    <message>
        <source>Remove joint</source>
        <translation>Retirer l’articulation</translation>
    </message>
    <message>
        <source>Join parts</source>
        <translation>Joindre des parties</translation>
    </message>
    <message>
        <source>Change what a part rides on</source>
        <translation>Changer ce que suit une partie</translation>
    </message>
    <message>
        <source>Multiply</source>
        <translation>Produit</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Écran</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Addition</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>Normal</translation>
    </message>
    <message>
        <source>&amp;Blend mode</source>
        <translation>Mode de f&amp;usion</translation>
    </message>
    <message>
        <source>Blend mode</source>
        <translation>Mode de fusion</translation>
    </message>
    <message>
        <source>How the part is combined with what is below it: Multiply darkens, as a shadow does; Screen and Add lighten, as light does.</source>
        <translation>Comment la partie se combine avec ce qui est dessous : Produit assombrit, comme une ombre ; Écran et Addition éclaircissent, comme la lumière.</translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation>Modifier le mode de fusion</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>Bord &amp;doux</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Bord doux</translation>
    </message>
    <message>
        <source>How wide the edge is along which the part was cut out. The colours of what is behind it are removed from it.</source>
        <translation>La largeur du bord le long duquel la partie a été découpée. Les couleurs de ce qui est derrière en sont retirées.</translation>
    </message>
    <message>
        <source>Change soft edge</source>
        <translation>Changer le bord doux</translation>
    </message>
    <message>
        <source>locked</source>
        <translation>verrouillée</translation>
    </message>
    <message>
        <source>The frontmost part is first. Drag a part, or press Alt with the arrow keys, to change what lies in front; click its eye to hide it; the lock at its end protects it from changes; a double-click changes its name.</source>
        <translation>La partie la plus en avant est la première. Faites glisser une partie, ou appuyez sur Alt et les flèches, pour changer l’ordre ; cliquez sur son œil pour la masquer ; le cadenas au bout la protège des modifications ; un double-clic change son nom.</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Verrouiller</translation>
    </message>
    <message>
        <source>The part is seen, but clicks go through it, and it is neither painted nor are its pins moved.</source>
        <translation>La partie se voit, mais les clics la traversent ; elle n’est pas peinte et ses épingles ne bougent pas.</translation>
    </message>
    <message>
        <source>Choose a part.</source>
        <translation>Choisissez une partie.</translation>
    </message>
    <message>
        <source>Lock part</source>
        <translation>Verrouiller la partie</translation>
    </message>
    <message>
        <source>Unlock part</source>
        <translation>Déverrouiller la partie</translation>
    </message>
</context>
<context>
    <name>wend::PartOrderRow</name>
    <message>
        <source>In Front from Here</source>
        <translation>Devant à partir d’ici</translation>
    </message>
    <message>
        <source>From the shown time on the part is in front of all others; before, it stays where it is.</source>
        <translation>À partir du temps affiché, la partie est devant toutes les autres&#x202f;; avant, elle reste où elle est.</translation>
    </message>
    <message>
        <source>Behind from Here</source>
        <translation>Derrière à partir d’ici</translation>
    </message>
    <message>
        <source>From the shown time on the part is behind all others; before, it stays where it is.</source>
        <translation>À partir du temps affiché, la partie est derrière toutes les autres&#x202f;; avant, elle reste où elle est.</translation>
    </message>
    <message>
        <source>Never</source>
        <translation>Jamais</translation>
    </message>
    <message>
        <source>Removes all changes of the order of this part.</source>
        <translation>Retire tous les changements d’ordre de cette partie.</translation>
    </message>
    <message>
        <source>Keep the order</source>
        <translation>Garder l’ordre</translation>
    </message>
    <message>
        <source>In front from here on</source>
        <translation>Devant à partir d’ici</translation>
    </message>
    <message>
        <source>Behind from here on</source>
        <translation>Derrière à partir d’ici</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Changes at %1</source>
        <translation>Change à %1</translation>
    </message>
</context>
<context>
    <name>wend::PictureActions</name>
    <message>
        <source>&amp;Add</source>
        <translation>A&amp;jouter</translation>
    </message>
    <message>
        <source>What you draw will bend, too; Ctrl takes it away instead</source>
        <translation>Ce que vous tracez se déformera aussi&#x202f;; avec Ctrl, c’est retiré</translation>
    </message>
    <message>
        <source>&amp;Take Away</source>
        <translation>Re&amp;tirer</translation>
    </message>
    <message>
        <source>What you draw will not bend; Ctrl adds it instead</source>
        <translation>Ce que vous tracez ne se déformera pas&#x202f;; avec Ctrl, c’est ajouté</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen; also [ and ]</source>
        <translation>La largeur du pinceau à l’écran&#x202f;; aussi [ et ]</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>How much colours may differ; this also changes the last click. Also [ and ]</source>
        <translation>L’écart permis entre couleurs, aussi pour le dernier clic ; aussi [ et ]</translation>
    </message>
    <message>
        <source>Make a &amp;Part</source>
        <translation>Créer une &amp;partie</translation>
    </message>
    <message>
        <source>What you draw becomes a part that bends by itself; what is behind it is filled</source>
        <translation>Ce que vous dessinez devient une partie qui se plie seule ; ce qui est derrière est rempli</translation>
    </message>
</context>
<context>
    <name>wend::PictureDialog</name>
    <message>
        <source>%1 has no transparency: the background is that of the view.</source>
        <translation>%1 n’a pas de transparence : l’arrière-plan est celui de la vue.</translation>
    </message>
    <message>
        <source>&amp;Proportions of the view</source>
        <translation>&amp;Proportions de la vue</translation>
    </message>
    <message>
        <source>&amp;Transparent background</source>
        <translation>Arrière-plan &amp;transparent</translation>
    </message>
    <message>
        <source>P&amp;ins and axes</source>
        <translation>Ép&amp;ingles et axes</translation>
    </message>
    <message>
        <source>Export View</source>
        <translation>Exporter la vue</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>What kind of file is written.</source>
        <translation>Le type de fichier à exporter.</translation>
    </message>
    <message>
        <source>Proportions of the view</source>
        <translation>Proportions de la vue</translation>
    </message>
    <message>
        <source>Width and height follow each other, so that the picture shows what the view shows.</source>
        <translation>Largeur et hauteur se suivent, pour que l’image montre ce que montre la vue.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>Largeur de l’image en pixels.</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Hauteur</translation>
    </message>
    <message>
        <source>Height of the picture in pixels; it decides how large the solid is.</source>
        <translation>Hauteur de l’image en pixels&#x202f;; elle détermine la taille du solide.</translation>
    </message>
    <message>
        <source>Transparent background</source>
        <translation>Arrière-plan transparent</translation>
    </message>
    <message>
        <source>Only the solid, without a background.</source>
        <translation>Le solide seul, sans fond.</translation>
    </message>
    <message>
        <source>Pins and axes</source>
        <translation>Épingles et axes</translation>
    </message>
    <message>
        <source>Pins, their paths and the axes, as large as in the window.</source>
        <translation>Épingles, trajectoires et axes, à la même taille que dans la fenêtre.</translation>
    </message>
    <message>
        <source>F&amp;ormat</source>
        <translation>Fo&amp;rmat</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>Lar&amp;geur</translation>
    </message>
    <message>
        <source>&amp;Height</source>
        <translation>&amp;Hauteur</translation>
    </message>
    <message>
        <source>Width and height must be between %1 and %2 pixels.</source>
        <translation>Largeur et hauteur doivent être comprises entre %1 et %2 pixels.</translation>
    </message>
    <message>
        <source>%1 × %2 pixels</source>
        <translation>%1 × %2 pixels</translation>
    </message>
    <message>
        <source>&amp;Legend of the overlay</source>
        <translation>&amp;Légende de l’incrustation</translation>
    </message>
    <message>
        <source>Legend of the overlay</source>
        <translation>Légende de l’incrustation</translation>
    </message>
    <message>
        <source>The colours of the overlay and their values.</source>
        <translation>Les couleurs de l’incrustation et leurs valeurs.</translation>
    </message>
    <message>
        <source>Show the colour overlay first: it has the legend.</source>
        <translation>Affichez d’abord l’incrustation couleur : la légende lui appartient.</translation>
    </message>
    <message>
        <source>Export Film</source>
        <translation>Exporter le film</translation>
    </message>
</context>
<context>
    <name>wend::PictureKeeper</name>
    <message>
        <source>The picture “%1” was changed by another program.</source>
        <translation>L’image « %1 » a été modifiée par un autre programme.</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Recharger</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Garder</translation>
    </message>
    <message>
        <source>Reload picture</source>
        <translation>Recharger l’image</translation>
    </message>
    <message>
        <source>Replace Picture</source>
        <translation>Remplacer l’image</translation>
    </message>
    <message>
        <source>Pictures (%1)</source>
        <translation>Images (%1)</translation>
    </message>
    <message>
        <source>Replace picture</source>
        <translation>Remplacer l’image</translation>
    </message>
    <message>
        <source>The picture cannot be read. %1</source>
        <translation>L’image ne peut pas être lue. %1</translation>
    </message>
    <message>
        <source>It has %1 × %2 pixels, and the picture before had %3 × %4.</source>
        <translation>Elle a %1 × %2 pixels, et l’image d’avant en avait %3 × %4.</translation>
    </message>
    <message>
        <source>This picture has other proportions. %1</source>
        <translation>Cette image a d’autres proportions. %1</translation>
    </message>
    <message>
        <source>The picture has other proportions now. %1</source>
        <translation>L’image a maintenant d’autres proportions. %1</translation>
    </message>
    <message>
        <source>Pins and paths are scaled with it. %1</source>
        <translation>Épingles et trajectoires sont mises à l’échelle avec elle. %1</translation>
    </message>
    <message>
        <source>Change drawing size</source>
        <translation>Changer la taille du dessin</translation>
    </message>
</context>
<context>
    <name>wend::PinActions</name>
    <message>
        <source>&amp;Pins</source>
        <translation>É&amp;pingles</translation>
    </message>
    <message>
        <source>&amp;Lock</source>
        <translation>Verrouille&amp;r</translation>
    </message>
    <message>
        <source>The selected pins are neither moved nor removed until unlocked</source>
        <translation>Empêcher de déplacer ou de supprimer les épingles sélectionnées jusqu’à leur déverrouillage</translation>
    </message>
    <message>
        <source>Ctrl+L</source>
        <translation>Ctrl+L</translation>
    </message>
    <message>
        <source>&amp;Hide</source>
        <translation>Mas&amp;quer</translation>
    </message>
    <message>
        <source>The selected pins still hold, but are neither drawn nor picked</source>
        <translation>Ne plus afficher ni laisser saisir les épingles sélectionnées, qui continuent de maintenir</translation>
    </message>
    <message>
        <source>Ctrl+Shift+H</source>
        <translation>Ctrl+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Show All</source>
        <translation>Tout a&amp;fficher</translation>
    </message>
    <message>
        <source>Show all hidden pins again</source>
        <translation>Afficher de nouveau toutes les épingles masquées</translation>
    </message>
    <message>
        <source>Alt+Shift+H</source>
        <translation>Alt+Shift+H</translation>
    </message>
    <message>
        <source>&amp;Group…</source>
        <translation>&amp;Grouper…</translation>
    </message>
    <message>
        <source>Put the selected pins under a heading of the list</source>
        <translation>Ranger les épingles sélectionnées sous un titre de la liste</translation>
    </message>
    <message>
        <source>Ctrl+G</source>
        <translation>Ctrl+G</translation>
    </message>
    <message>
        <source>&amp;Ungroup</source>
        <translation>Dégro&amp;uper</translation>
    </message>
    <message>
        <source>Take the selected pins out of their groups</source>
        <translation>Retirer les épingles sélectionnées de leurs groupes</translation>
    </message>
    <message>
        <source>Ctrl+Shift+G</source>
        <translation>Ctrl+Shift+G</translation>
    </message>
    <message>
        <source>Lin&amp;k</source>
        <translation>L&amp;ier</translation>
    </message>
    <message>
        <source>The selected pins move together, whichever of them is dragged</source>
        <translation>Déplacer ensemble les épingles sélectionnées, quelle que soit celle que l’on tire</translation>
    </message>
    <message>
        <source>Ctrl+K</source>
        <translation>Ctrl+K</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>Mettre en &amp;miroir</translation>
    </message>
    <message>
        <source>Set pins at the mirror images of the selected ones, across the middle of the shape, with mirrored motions</source>
        <translation>Poser des épingles symétriques de celles sélectionnées par rapport au milieu de la forme, avec des mouvements en miroir</translation>
    </message>
    <message>
        <source>Ctrl+M</source>
        <translation>Ctrl+M</translation>
    </message>
    <message>
        <source>Mirror M&amp;otion</source>
        <translation>Mouveme&amp;nt en miroir</translation>
    </message>
    <message>
        <source>The selected pins move to the other side instead</source>
        <translation>Diriger plutôt les épingles sélectionnées vers l’autre côté</translation>
    </message>
    <message>
        <source>Ctrl+Shift+M</source>
        <translation>Ctrl+Shift+M</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Bleu</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Orange</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Vert</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rouge</translation>
    </message>
    <message>
        <source>Violet</source>
        <translation>Violet</translation>
    </message>
    <message>
        <source>Brown</source>
        <translation>Brun</translation>
    </message>
    <message>
        <source>Turquoise</source>
        <translation>Turquoise</translation>
    </message>
    <message>
        <source>Plum</source>
        <translation>Prune</translation>
    </message>
    <message>
        <source>&amp;Colour</source>
        <translation>&amp;Couleur</translation>
    </message>
    <message>
        <source>By &amp;Place in the List</source>
        <translation>Selon la &amp;place dans la liste</translation>
    </message>
    <message>
        <source>&amp;Other…</source>
        <translation>&amp;Autre…</translation>
    </message>
    <message>
        <source>Select a pin first.</source>
        <translation>Sélectionnez d’abord une épingle.</translation>
    </message>
    <message>
        <source>The selected pin is in no group.</source>
        <translation>L’épingle sélectionnée n’est dans aucun groupe.</translation>
    </message>
    <message>
        <source>Select several pins first.</source>
        <translation>Sélectionnez d’abord plusieurs épingles.</translation>
    </message>
    <message>
        <source>Select a pin that moves.</source>
        <translation>Sélectionnez une épingle qui bouge.</translation>
    </message>
    <message>
        <source>No pin is hidden.</source>
        <translation>Aucune épingle n’est masquée.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grouper</translation>
    </message>
    <message>
        <source>Name of the group:</source>
        <translation>Nom du groupe&#x202f;:</translation>
    </message>
    <message>
        <source>Colour of the Pin</source>
        <translation>Couleur de l’épingle</translation>
    </message>
    <message>
        <source>Ctrl+Shift+F</source>
        <translation>Ctrl+Shift+F</translation>
    </message>
    <message>
        <source>Mo&amp;ve</source>
        <translation>Déplace&amp;r</translation>
    </message>
    <message>
        <source>Drag pins to move them; in a solid, also by the arrows</source>
        <translation>Tirez les épingles pour les déplacer ; pour un solide, ses flèches aussi</translation>
    </message>
    <message>
        <source>G</source>
        <translation>G</translation>
    </message>
    <message>
        <source>&amp;Rotate</source>
        <translation>Faire pi&amp;voter</translation>
    </message>
    <message>
        <source>Drag to rotate the selected pins; in a solid, by the rings</source>
        <translation>Tirez pour faire pivoter les épingles sélectionnées ; pour un solide, par ses anneaux</translation>
    </message>
    <message>
        <source>R</source>
        <translation>R</translation>
    </message>
    <message>
        <source>Sc&amp;ale</source>
        <translation>Éche&amp;lle</translation>
    </message>
    <message>
        <source>Drag to scale the selected pins; in a solid, by the ring</source>
        <translation>Tirez pour redimensionner les épingles sélectionnées ; pour un solide, par son anneau</translation>
    </message>
    <message>
        <source>S</source>
        <translation>S</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Ouvrez d’abord une image.</translation>
    </message>
    <message>
        <source>Select &amp;Pins</source>
        <translation>Sélectionner des épin&amp;gles</translation>
    </message>
    <message>
        <source>What the pin tool and the select tool draw around pins to select them</source>
        <translation>Ce qu’on trace à côté des épingles, avec l’outil Épingle ou Sélection, pour les sélectionner</translation>
    </message>
    <message>
        <source>By &amp;Rectangle</source>
        <translation>Au &amp;rectangle</translation>
    </message>
    <message>
        <source>Shift+R</source>
        <translation>Shift+R</translation>
    </message>
    <message>
        <source>By &amp;Lasso</source>
        <translation>Au &amp;lasso</translation>
    </message>
    <message>
        <source>Shift+O</source>
        <translation>Shift+O</translation>
    </message>
    <message>
        <source>By &amp;Brush</source>
        <translation>Au &amp;pinceau</translation>
    </message>
    <message>
        <source>Shift+U</source>
        <translation>Shift+U</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>Aima&amp;nter</translation>
    </message>
    <message>
        <source>New pins sit on corners of the mesh instead of where you click</source>
        <translation>Poser les nouvelles épingles sur les sommets du maillage plutôt qu’à l’endroit cliqué</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Diameter of the brush on the screen. Also by the keys [ and ].</source>
        <translation>Le diamètre du pinceau à l’écran&#x202f;; aussi avec les touches [ et ].</translation>
    </message>
    <message>
        <source> px</source>
        <translation> px</translation>
    </message>
    <message>
        <source>Pin for the Whole &amp;Animation</source>
        <translation>Épingler toute l’&amp;animation</translation>
    </message>
    <message>
        <source>The selected pins hold from the start of the animation to its end, not only from the time at which they were set</source>
        <translation>Les épingles sélectionnées tiennent du début à la fin de l’animation, pas seulement à partir de l’instant où elles ont été posées</translation>
    </message>
    <message>
        <source>The selected pin already holds for the whole animation.</source>
        <translation>L’épingle sélectionnée tient déjà toute l’animation.</translation>
    </message>
</context>
<context>
    <name>wend::PinList</name>
    <message>
        <source>Pins</source>
        <translation>Épingles</translation>
    </message>
    <message>
        <source>Does not hold at the time shown.</source>
        <translation>Ne maintient rien à l’instant affiché.</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Choose pins here; F2 renames, Delete removes, Enter goes to the picture, where the arrow keys move them. The eye hides, the lock protects from changes; a right-click groups, links and mirrors.</source>
        <translation>Choisissez ici des épingles&#x202f;; F2 renomme, Suppr supprime, Entrée passe à l’image, où les flèches les déplacent. L’œil masque, le cadenas protège des modifications&#x202f;; le clic droit groupe, lie et met en miroir.</translation>
    </message>
    <message>
        <source>Moves together with others</source>
        <translation>Bouge avec d’autres</translation>
    </message>
    <message>
        <source>Hidden: a click shows it</source>
        <translation>Masquée&#x202f;: un clic l’affiche</translation>
    </message>
    <message>
        <source>A click hides it</source>
        <translation>Un clic la masque</translation>
    </message>
    <message>
        <source>Locked: a click unlocks it</source>
        <translation>Verrouillée&#x202f;: un clic la déverrouille</translation>
    </message>
    <message>
        <source>A click locks it</source>
        <translation>Un clic la verrouille</translation>
    </message>
    <message>
        <source>No pins yet</source>
        <translation>Pas encore d’épingles</translation>
    </message>
</context>
<context>
    <name>wend::ProblemRemedies</name>
    <message>
        <source>Use Multigrid</source>
        <translation>Utiliser le multigrille</translation>
    </message>
    <message>
        <source>Half as Many Vertices</source>
        <translation>Deux fois moins de sommets</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>wend::Properties</name>
    <message>
        <source>Advanced</source>
        <translation>Avancé</translation>
    </message>
    <message>
        <source>The same in numbers, for those who want them.</source>
        <translation>La même chose en nombres, pour qui le souhaite.</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Détail</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Profondeur</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>Calques</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Épingles</translation>
    </message>
    <message>
        <source>Selection</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Flow</source>
        <translation>Flux</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Coupe</translation>
    </message>
    <message>
        <source>What changed</source>
        <translation>Ce qui a changé</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conserver</translation>
    </message>
    <message>
        <source>Facts</source>
        <translation>Données</translation>
    </message>
    <message>
        <source>Size, area, volume and edges, the quality of the cells, and gaps that a cage closes.</source>
        <translation>Taille, aire, volume et arêtes, qualité des cellules et fentes qu&apos;une cage ferme.</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>Parties</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
</context>
<context>
    <name>wend::PropertiesRail</name>
    <message>
        <source>Opens this part of the properties over the view; Esc closes it.</source>
        <translation>Ouvre cette partie des propriétés par-dessus la vue ; Échap la ferme.</translation>
    </message>
</context>
<context>
    <name>wend::ReachRow</name>
    <message>
        <source>Pull reaches</source>
        <translation>Portée</translation>
    </message>
    <message>
        <source>How far a pin&apos;s pull spreads. Near: close to the pin, sharp. Far: soft and wide.</source>
        <translation>Jusqu’où s’étend la traction d’une épingle. Près&#x202f;: près de l’épingle, net. Loin&#x202f;: doux et large.</translation>
    </message>
    <message>
        <source>Pull &amp;reaches</source>
        <translation>Po&amp;rtée</translation>
    </message>
    <message>
        <source>near</source>
        <translation>près</translation>
    </message>
    <message>
        <source>far</source>
        <translation>loin</translation>
    </message>
    <message>
        <source>This project smooths as in the paper, with λ; its file says how much.</source>
        <translation>Ce projet est lissé comme dans l’article, avec λ&#x202f;; son fichier dit de combien.</translation>
    </message>
</context>
<context>
    <name>wend::RegionList</name>
    <message>
        <source>The mesh is equally fine everywhere: brush over what should be finer or coarser.</source>
        <translation>Le maillage est partout aussi fin&#x202f;: passez le pinceau où il doit être plus fin ou plus grossier.</translation>
    </message>
    <message>
        <source>Nothing has an order of its own: brush over what should lie in front or behind.</source>
        <translation>Rien n’a d’ordre propre&#x202f;: passez le pinceau sur ce qui doit être devant ou derrière.</translation>
    </message>
    <message>
        <source>Where the mesh is finer or coarser</source>
        <translation>Où le maillage est plus fin ou plus grossier</translation>
    </message>
    <message>
        <source>What lies in front</source>
        <translation>Ce qui est devant</translation>
    </message>
    <message>
        <source>The strokes and regions so far; where two overlap, the upper one counts. A click shows where it lies and its number, a double-click changes its name.</source>
        <translation>Les traits et régions présents&#x202f;; de deux au même endroit, celui du dessus compte. Un clic montre où il se trouve et sa valeur, un double-clic change son nom.</translation>
    </message>
    <message>
        <source> %</source>
        <translation>&#x202f;%</translation>
    </message>
    <message>
        <source>Length of edges</source>
        <translation>Longueur des arêtes</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>How long edges are there, compared with elsewhere: less is finer, more is coarser.</source>
        <translation>Longueur des arêtes à cet endroit par rapport à ailleurs&#x202f;: moins est plus fin, plus est plus grossier.</translation>
    </message>
    <message>
        <source>Greater than 0 lies in front, less than 0 behind.</source>
        <translation>Plus grand que 0&#x202f;: devant&#x202f;; plus petit&#x202f;: derrière.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Removes the chosen region.</source>
        <translation>Supprime la région choisie.</translation>
    </message>
    <message>
        <source>Finer and coarser</source>
        <translation>Plus fin ou grossier</translation>
    </message>
    <message>
        <source>In front and behind</source>
        <translation>Devant et derrière</translation>
    </message>
    <message>
        <source>E&amp;dges</source>
        <translation>Arê&amp;tes</translation>
    </message>
    <message>
        <source>O&amp;rder</source>
        <translation>Or&amp;dre</translation>
    </message>
    <message>
        <source>Change edges</source>
        <translation>Modifier les arêtes</translation>
    </message>
    <message>
        <source>Change order</source>
        <translation>Modifier l’ordre</translation>
    </message>
    <message>
        <source>Remove region</source>
        <translation>Supprimer la région</translation>
    </message>
    <message>
        <source>Circle</source>
        <translation>Cercle</translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation>Rectangle</translation>
    </message>
    <message>
        <source>One side</source>
        <translation>Un côté</translation>
    </message>
    <message>
        <source>Outline</source>
        <translation>Contour</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Rename region</source>
        <translation>Renommer la région</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Add region</source>
        <translation>Ajouter une région</translation>
    </message>
    <message>
        <source>A ball, a box or a half-space in the middle, or what the selected handle holds as a region; its numbers can then be changed.</source>
        <translation>Une sphère, une boîte ou un demi-espace au milieu, ou la région que maintient la poignée sélectionnée&#x202f;; on peut ensuite en changer les nombres.</translation>
    </message>
    <message>
        <source>Soft edge</source>
        <translation>Bord doux</translation>
    </message>
    <message>
        <source>Over what width the size blends into that around it, in the file&apos;s units.</source>
        <translation>Largeur sur laquelle la taille passe à celle d’alentour, en unités du fichier.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Demi-espace</translation>
    </message>
    <message>
        <source>Blend</source>
        <translation>Dégradé</translation>
    </message>
    <message>
        <source>Region of the selected handle</source>
        <translation>Région de la poignée sélectionnée</translation>
    </message>
    <message>
        <source>Soft ed&amp;ge</source>
        <translation>&amp;Bord doux</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Modifier la région</translation>
    </message>
    <message>
        <source>Add size region</source>
        <translation>Ajouter une région de taille</translation>
    </message>
    <message>
        <source>First select a pin that holds a ball, a box or one side.</source>
        <translation>Sélectionnez d’abord une épingle qui maintient une boule, un bloc ou un côté.</translation>
    </message>
    <message>
        <source>Beneath them: the factors in %1.</source>
        <translation>En dessous&#x202f;: les facteurs de %1.</translation>
    </message>
    <message>
        <source>The surface&apos;s triangles are kept, and only the inside changes. “Refine surface” in the panel “Mesh” allows them to be split, too.</source>
        <translation>Les triangles de la surface sont conservés, seul l’intérieur change. «&#x202f;Raffiner la surface&#x202f;» dans le panneau «&#x202f;Maillage&#x202f;» permet de les diviser aussi.</translation>
    </message>
</context>
<context>
    <name>wend::RegionNumbers</name>
    <message>
        <source>Numbers of the region</source>
        <translation>Nombres de la région</translation>
    </message>
    <message>
        <source>As x, y and z, in the coordinates of the rest shape.</source>
        <translation>En x, y et z, dans les coordonnées de la forme au repos.</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>Sphère</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Boîte</translation>
    </message>
    <message>
        <source>Half-space</source>
        <translation>Demi-espace</translation>
    </message>
    <message>
        <source>Kind of region</source>
        <translation>Type de région</translation>
    </message>
    <message>
        <source>What the region is; another kind keeps its place.</source>
        <translation>Ce qu’est la région&#x202f;; un autre type garde sa place.</translation>
    </message>
    <message>
        <source>&amp;Region</source>
        <translation>Ré&amp;gion</translation>
    </message>
    <message>
        <source>centre</source>
        <translation>centre</translation>
    </message>
    <message>
        <source>from</source>
        <translation>de</translation>
    </message>
    <message>
        <source>point of the plane</source>
        <translation>point du plan</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>direction into it</source>
        <translation>direction intérieure</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>The radius of the ball.</source>
        <translation>Le rayon de la sphère.</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Ra&amp;yon</translation>
    </message>
</context>
<context>
    <name>wend::RegionPanel</name>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>There is no vertex in this region: nothing was changed.</source>
        <translation>Il n’y a aucun sommet dans cette région&#x202f;: rien n’a été changé.</translation>
    </message>
    <message>
        <source>Change region</source>
        <translation>Modifier la région</translation>
    </message>
    <message numerus="yes">
        <source>Vertices: %n</source>
        <translation>
            <numerusform>%n sommet</numerusform>
            <numerusform>%n sommets</numerusform>
        </translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>Ra&amp;dius</source>
        <translation>Rayo&amp;n</translation>
    </message>
    <message>
        <source>Holds its a&amp;ngle</source>
        <translation>&amp;Garde son angle</translation>
    </message>
    <message>
        <source>How far the pin holds the shape around it: 0 holds a point, more a circle, or in a solid a ball. In the shape&apos;s own units, for a picture its pixels. Dragging the pin with Ctrl and Shift does the same.</source>
        <translation>Jusqu’où l’épingle tient la forme autour d’elle&#x202f;: 0 tient un point, plus un cercle, ou dans un solide une boule. Dans l’unité de la forme, pour une image ses pixels. Glisser l’épingle avec Ctrl et Maj fait la même chose.</translation>
    </message>
    <message>
        <source>The pin keeps the angle that the picture has there now, as a small circle; without it, the picture turns freely around the pin.</source>
        <translation>L’épingle garde, comme petit cercle, l’angle que l’image y a maintenant&#x202f;; sans cela, l’image tourne librement autour de l’épingle.</translation>
    </message>
</context>
<context>
    <name>wend::RidingOffer</name>
    <message>
        <source>A part has no pin and stays behind: let it ride on “%1”?</source>
        <translation>Une partie n’a pas d’épingle et reste en arrière&#x202f;: doit-elle suivre «&#x202f;%1&#x202f;»&#x202f;?</translation>
    </message>
    <message>
        <source>A part has no pin and stays behind: let it ride on what is beside it?</source>
        <translation>Une partie n’a pas d’épingle et reste en arrière&#x202f;: doit-elle suivre ce qui est à côté d’elle&#x202f;?</translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on “%1”?</source>
        <translation>
            <numerusform>%n partie n’a pas d’épingle et reste en arrière&#x202f;: doit-elle suivre «&#x202f;%1&#x202f;»&#x202f;?</numerusform>
            <numerusform>%n parties n’ont pas d’épingle et restent en arrière&#x202f;: doivent-elles suivre «&#x202f;%1&#x202f;»&#x202f;?</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n parts have no pin and stay behind: let them ride on what is beside them?</source>
        <translation>
            <numerusform>%n partie n’a pas d’épingle et reste en arrière&#x202f;: doit-elle suivre ce qui est à côté d’elle&#x202f;?</numerusform>
            <numerusform>%n parties n’ont pas d’épingle et restent en arrière&#x202f;: doivent-elles suivre ce qui est à côté d’elles&#x202f;?</numerusform>
        </translation>
    </message>
    <message>
        <source>Let parts ride</source>
        <translation>Faire suivre des parties</translation>
    </message>
    <message>
        <source>Let It Ride</source>
        <translation>Faire suivre</translation>
    </message>
    <message>
        <source>Let Them Ride</source>
        <translation>Faire suivre</translation>
    </message>
</context>
<context>
    <name>wend::ShapeCanvas</name>
    <message>
        <source>Canvas</source>
        <translation>Toile</translation>
    </message>
    <message>
        <source>The picture with its pins</source>
        <translation>L’image avec ses épingles</translation>
    </message>
</context>
<context>
    <name>wend::ShapeNotices</name>
    <message>
        <source>“Refine surface” in the panel “Mesh” allows the surface&apos;s triangles to be split.</source>
        <translation>«&#x202f;Raffiner la surface&#x202f;» dans le panneau «&#x202f;Maillage&#x202f;» permet de diviser les triangles de la surface.</translation>
    </message>
    <message>
        <source>Pin It</source>
        <translation>Épingler</translation>
    </message>
    <message>
        <source>A part is joined to the rest at a single point, and may swing around it unless a pin holds it.</source>
        <translation>Une partie ne tient au reste que par un point et peut pivoter autour, si aucune épingle ne la maintient.</translation>
    </message>
    <message numerus="yes">
        <source>%n parts are joined to the rest at single points, and may swing around them unless pins hold them.</source>
        <translation>
            <numerusform>%n partie ne tient au reste que par un point et peut pivoter autour, si aucune épingle ne la maintient.</numerusform>
            <numerusform>%n parties ne tiennent au reste que par des points et peuvent pivoter autour, si aucune épingle ne les maintient.</numerusform>
        </translation>
    </message>
    <message>
        <source>See Why</source>
        <translation>Voir pourquoi</translation>
    </message>
    <message>
        <source>Fill All, with Labels</source>
        <translation>Tout remplir, avec étiquettes</translation>
    </message>
    <message>
        <source>Leave Holes</source>
        <translation>Laisser des trous</translation>
    </message>
</context>
<context>
    <name>wend::ShapeSession</name>
    <message>
        <source>Widen %1</source>
        <translation>Élargir %1</translation>
    </message>
    <message>
        <source>%1 cannot go further: %2</source>
        <translation>%1 ne peut pas aller plus loin&#x202f;: %2</translation>
    </message>
    <message>
        <source>Cancelled: everything is as it was before the last change.</source>
        <translation>Annulé&#x202f;: tout est comme avant la dernière modification.</translation>
    </message>
    <message>
        <source>Meshing was cancelled. Any change, such as fewer vertices, starts it again.</source>
        <translation>Le maillage a été annulé. Toute modification le relance, par exemple réduire le nombre de sommets.</translation>
    </message>
    <message>
        <source>The motion was cancelled. Any change computes it again.</source>
        <translation>Le mouvement a été annulé. Toute modification le recalcule.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>No pin was set: this place lies outside the shape.</source>
        <translation>Pas d’épingle ici&#x202f;: cet endroit est hors de la forme.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>%1 does not hold the shape at the time shown.</source>
        <translation>%1 ne maintient pas la forme à l’instant affiché.</translation>
    </message>
    <message>
        <source>Scale %1</source>
        <translation>Mettre %1 à l’échelle</translation>
    </message>
    <message>
        <source>This replaces what came after; Undo brings it back.</source>
        <translation>Ce qui venait après est remplacé&#x202f;; Annuler le rétablit.</translation>
    </message>
    <message numerus="yes">
        <source>%n pins</source>
        <translation>
            <numerusform>%n épingle</numerusform>
            <numerusform>%n épingles</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 mirrored</source>
        <translation>%1 en miroir</translation>
    </message>
    <message>
        <source>No pin was set where the mirror image lies outside the shape.</source>
        <translation>Là où l’image en miroir tombe hors de la forme, aucune épingle n’est posée.</translation>
    </message>
    <message>
        <source>There is already a pin where the mirror image would be.</source>
        <translation>Il y a déjà une épingle là où serait l’image en miroir.</translation>
    </message>
    <message>
        <source>Mirror %1</source>
        <translation>Mettre %1 en miroir</translation>
    </message>
    <message>
        <source>Mirror the motion of %1</source>
        <translation>Mettre en miroir le mouvement de %1</translation>
    </message>
    <message>
        <source>Lock %1</source>
        <translation>Verrouiller %1</translation>
    </message>
    <message>
        <source>Unlock %1</source>
        <translation>Déverrouiller %1</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>Masquer %1</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Afficher %1</translation>
    </message>
    <message>
        <source>Ungroup %1</source>
        <translation>Dégrouper %1</translation>
    </message>
    <message>
        <source>Group %1</source>
        <translation>Grouper %1</translation>
    </message>
    <message>
        <source>Rename group</source>
        <translation>Renommer le groupe</translation>
    </message>
    <message>
        <source>Colour %1</source>
        <translation>Changer la couleur de %1</translation>
    </message>
    <message>
        <source>Link %1</source>
        <translation>Lier %1</translation>
    </message>
    <message>
        <source>Unlink %1</source>
        <translation>Délier %1</translation>
    </message>
    <message>
        <source>%1 is locked. A right-click or the list of pins unlocks it.</source>
        <translation>%1 est verrouillée. Le clic droit ou la liste des épingles la déverrouille.</translation>
    </message>
    <message>
        <source>%1 are locked. A right-click or the list of pins unlocks them.</source>
        <translation>%1 sont verrouillées. Le clic droit ou la liste des épingles les déverrouille.</translation>
    </message>
    <message>
        <source>Record %1</source>
        <translation>Enregistrer %1</translation>
    </message>
    <message>
        <source>Recorded. K plays it; record other pins from the same time, and they move together.</source>
        <translation>Enregistré. K le lit&#x202f;; d’autres épingles enregistrées depuis le même instant bougent ensemble.</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Épingle</translation>
    </message>
    <message>
        <source>Edit path</source>
        <translation>Modifier la trajectoire</translation>
    </message>
    <message>
        <source>Draw the path of %1</source>
        <translation>Dessiner la trajectoire de %1</translation>
    </message>
    <message>
        <source>K plays it; draw the paths of other pins from the same time, and they move together.</source>
        <translation>K lance la lecture ; dessinez les trajectoires d’autres épingles à partir du même temps, et elles bougent ensemble.</translation>
    </message>
    <message>
        <source>Relax</source>
        <translation>Détendre</translation>
    </message>
    <message>
        <source>Rotate %1</source>
        <translation>Faire pivoter %1</translation>
    </message>
    <message>
        <source>This replaces what %1 did later; Undo brings it back.</source>
        <translation>Ce que %1 faisait après est remplacé ; Annuler le rétablit.</translation>
    </message>
    <message>
        <source>This circle is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>Ce cercle est plus petit que les mailles&#x202f;: agrandissez-le, ou affinez le maillage.</translation>
    </message>
    <message>
        <source>This ball is smaller than the mesh: make it larger, or the mesh finer.</source>
        <translation>Cette boule est plus petite que les mailles&#x202f;: agrandissez-la, ou affinez le maillage.</translation>
    </message>
    <message>
        <source>Pin %1 for the whole animation</source>
        <translation>Épingler %1 toute l’animation</translation>
    </message>
    <message>
        <source>The film is longer by a second: what you had timed keeps its times.</source>
        <translation>Le film dure une seconde de plus : ce que vous aviez réglé garde ses temps.</translation>
    </message>
    <message>
        <source>The film is longer by a second. At an earlier time a drag sets the pose there.</source>
        <translation>Le film dure une seconde de plus. À un temps antérieur, un glissement y fixe la pose.</translation>
    </message>
    <message>
        <source>Posed at %1 s: what comes before and after stays.</source>
        <translation>Pose à %1 s : ce qui précède et ce qui suit reste.</translation>
    </message>
    <message>
        <source>No pose was set where a pin begins, rotates or does not hold: show another time.</source>
        <translation>Aucune pose n’a été fixée là où une épingle commence, tourne ou ne tient pas : affichez un autre instant.</translation>
    </message>
    <message>
        <source>Hold %1</source>
        <translation>Tenir %1</translation>
    </message>
    <message>
        <source>The last move goes straight there now. Motion ▸ Keep the Path leads pins on instead.</source>
        <translation>Le dernier mouvement y va maintenant tout droit. Mouvement ▸ Garder le trajet mène plutôt les épingles plus loin.</translation>
    </message>
    <message>
        <source>%1 is in a part that is locked. The list of parts unlocks it.</source>
        <translation>%1 est dans une partie verrouillée. La liste des parties la déverrouille.</translation>
    </message>
    <message>
        <source>A part is still being made. Pins can be dragged as soon as it is there.</source>
        <translation>Une partie est encore en cours de création. Les épingles pourront être déplacées dès qu’elle sera là.</translation>
    </message>
    <message>
        <source>The motion stops at %1 s: %2</source>
        <translation>Le mouvement s’arrête à %1 s&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>wend::ShortcutDialog</name>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Aucune</translation>
    </message>
    <message>
        <source>&amp;Standard</source>
        <translation>&amp;Standard</translation>
    </message>
    <message>
        <source>Keyboard Shortcuts</source>
        <translation>Raccourcis clavier</translation>
    </message>
    <message>
        <source>Search for an action or for keys</source>
        <translation>Chercher une commande ou des touches</translation>
    </message>
    <message>
        <source>&amp;All Standard</source>
        <translation>&amp;Tout par défaut</translation>
    </message>
    <message>
        <source>Give every action the keys that it has in a new Wend</source>
        <translation>Donner à chaque commande les touches d’origine de Wend</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Touches</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>Click here, then press the keys</source>
        <translation>Cliquez ici, puis appuyez sur les touches</translation>
    </message>
    <message>
        <source>Leave the chosen action without keys</source>
        <translation>Laisser la commande choisie sans touches</translation>
    </message>
    <message>
        <source>Give the chosen action the keys that it has in a new Wend</source>
        <translation>Donner à la commande choisie les touches d’origine de Wend</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>Commande</translation>
    </message>
    <message>
        <source>Actions</source>
        <translation>Commandes</translation>
    </message>
    <message>
        <source>Choose an action, then press the keys that it shall have.</source>
        <translation>Choisissez une commande, puis appuyez sur les touches voulues.</translation>
    </message>
    <message>
        <source>%1 cannot be chosen: the canvas uses it.</source>
        <translation>%1 ne peut pas être choisi : le canevas s’en sert.</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>« %1 »</translation>
    </message>
    <message>
        <source>Taken from %1.</source>
        <translation>Retiré à %1.</translation>
    </message>
</context>
<context>
    <name>wend::SideWindows</name>
    <message>
        <source>As it was opened</source>
        <translation>À l’ouverture</translation>
    </message>
    <message>
        <source>What was done; a click goes back or forward to that step.</source>
        <translation>Ce qui a été fait&#x202f;; un clic ramène à cette étape, ou y avance.</translation>
    </message>
    <message>
        <source>About Wend</source>
        <translation>À propos de Wend</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Bends pictures and solids by letting them flow.&lt;/p&gt;&lt;p&gt;After J. Martinez Esturo, C. Rössl, H. Theisel: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Free software under the GNU Affero General Public License, version 3 or later.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Wend %1&lt;/h3&gt;&lt;p&gt;Déforme images et solides en les laissant s’écouler comme un fluide.&lt;/p&gt;&lt;p&gt;D’après J. Martinez Esturo, C. Rössl, H. Theisel&#x202f;: Generalized Metric Energies for Continuous Shape Deformation, 2013.&lt;/p&gt;&lt;p&gt;Logiciel libre sous licence GNU Affero General Public License, version 3 ou ultérieure.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
</context>
<context>
    <name>wend::SolidActions</name>
    <message>
        <source>Through the &amp;Solid</source>
        <translation>À &amp;travers le solide</translation>
    </message>
    <message>
        <source>Rectangle, lasso and brush also take or select what is hidden</source>
        <translation>Rectangle, lasso et pinceau prennent ou sélectionnent aussi ce qui est caché</translation>
    </message>
    <message>
        <source>T</source>
        <translation>T</translation>
    </message>
    <message>
        <source>Grab Beyond the &amp;Cut</source>
        <translation>Saisir au-&amp;delà de la coupe</translation>
    </message>
    <message>
        <source>Take hold of all that the cut takes away, as one handle</source>
        <translation>Saisir en une seule poignée tout ce que la coupe retire</translation>
    </message>
    <message>
        <source>Ctrl+B</source>
        <translation>Ctrl+B</translation>
    </message>
    <message>
        <source>S&amp;kin</source>
        <translation>&amp;Peau</translation>
    </message>
    <message>
        <source>Show the detailed or textured surface embedded in the solid; off: the border of the tetrahedra, which bend</source>
        <translation>Afficher la surface détaillée ou texturée qui suit le solide&#x202f;; sinon, le bord des tétraèdres, qui se déforment</translation>
    </message>
    <message>
        <source>Shift+D</source>
        <translation>Shift+D</translation>
    </message>
    <message>
        <source>Choose Sk&amp;in…</source>
        <translation>Ch&amp;oisir une peau…</translation>
    </message>
    <message>
        <source>Embed a detailed, perhaps textured surface from a file in the solid</source>
        <translation>Faire suivre le solide par une surface détaillée, éventuellement texturée, prise dans un fichier</translation>
    </message>
    <message>
        <source>Re&amp;move Skin</source>
        <translation>Supprimer l&amp;a peau</translation>
    </message>
    <message>
        <source>Show and export the solid with its own surface again</source>
        <translation>Afficher et exporter de nouveau le solide avec sa propre surface</translation>
    </message>
    <message>
        <source>&amp;Flat Faces</source>
        <translation>&amp;Faces planes</translation>
    </message>
    <message>
        <source>Shade every triangle by itself instead of smoothly</source>
        <translation>Ombrer chaque triangle à part, sans adoucir</translation>
    </message>
    <message>
        <source>Shift+F</source>
        <translation>Shift+F</translation>
    </message>
    <message>
        <source>&amp;Parallel View</source>
        <translation>Vue pa&amp;rallèle</translation>
    </message>
    <message>
        <source>See without perspective</source>
        <translation>Voir sans perspective</translation>
    </message>
    <message>
        <source>5</source>
        <translation>5</translation>
    </message>
    <message>
        <source>&amp;Cut Open</source>
        <translation>&amp;Couper</translation>
    </message>
    <message>
        <source>Look inside along a plane; an arrow and rings move and tilt it</source>
        <translation>Regarder à l’intérieur le long d’un plan&#x202f;; une flèche et des anneaux le déplacent et l’inclinent</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>Look along an axis of the world</source>
        <translation>Regarder le long d’un axe du monde</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>&amp;Face</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Arrière</translation>
    </message>
    <message>
        <source>&amp;Right</source>
        <translation>&amp;Droite</translation>
    </message>
    <message>
        <source>3</source>
        <translation>3</translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation>&amp;Gauche</translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation>Dess&amp;us</translation>
    </message>
    <message>
        <source>7</source>
        <translation>7</translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation>Dess&amp;ous</translation>
    </message>
    <message>
        <source>&amp;Oblique</source>
        <translation>O&amp;blique</translation>
    </message>
    <message>
        <source>Look from the side and above</source>
        <translation>Regarder de côté et d’en haut</translation>
    </message>
    <message>
        <source>0</source>
        <translation>0</translation>
    </message>
    <message>
        <source>&amp;Wend</source>
        <translation>&amp;Wend</translation>
    </message>
    <message>
        <source>Right or middle button turns, with Shift moves; the wheel zooms</source>
        <translation>Le bouton droit ou central tourne, avec Maj déplace&#x202f;; la molette zoome</translation>
    </message>
    <message>
        <source>Like &amp;VTK</source>
        <translation>Comme &amp;VTK</translation>
    </message>
    <message>
        <source>Left button turns, middle moves, right zooms, as in ParaView</source>
        <translation>Le bouton gauche tourne, le central déplace, le droit zoome, comme dans ParaView</translation>
    </message>
    <message>
        <source>Like &amp;Blender</source>
        <translation>Comme &amp;Blender</translation>
    </message>
    <message>
        <source>Middle button turns, with Shift moves, with Ctrl zooms</source>
        <translation>Le bouton central tourne, avec Maj déplace, avec Ctrl zoome</translation>
    </message>
    <message>
        <source>&amp;Solid</source>
        <translation>&amp;Solide</translation>
    </message>
    <message>
        <source>L&amp;ook from</source>
        <translation>Point de v&amp;ue</translation>
    </message>
    <message>
        <source>&amp;Navigation</source>
        <translation>&amp;Navigation</translation>
    </message>
    <message>
        <source>The solid has neither a detailed surface nor materials.</source>
        <translation>Le solide n’a ni surface détaillée ni matériaux.</translation>
    </message>
    <message>
        <source>No detailed surface was chosen for the solid.</source>
        <translation>Aucune surface détaillée n’a été choisie pour le solide.</translation>
    </message>
    <message>
        <source>The mesh comes from a file and is used as it is.</source>
        <translation>Le maillage vient d’un fichier et sert tel quel.</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>Ouvrez d’abord un solide.</translation>
    </message>
    <message>
        <source>Which axis of the world points up in the view; kept with the project</source>
        <translation>Quel axe du monde pointe vers le haut dans la vue&#x202f;; conservé avec le projet</translation>
    </message>
    <message>
        <source>&amp;X Points Up</source>
        <translation>&amp;X vers le haut</translation>
    </message>
    <message>
        <source>&amp;Y Points Up</source>
        <translation>&amp;Y vers le haut</translation>
    </message>
    <message>
        <source>&amp;Z Points Up</source>
        <translation>&amp;Z vers le haut</translation>
    </message>
    <message>
        <source>&amp;Up Axis</source>
        <translation>A&amp;xe vertical</translation>
    </message>
</context>
<context>
    <name>wend::SolidCanvas</name>
    <message>
        <source>there is not enough memory for a picture of %1 x %2 pixels</source>
        <translation>la mémoire ne suffit pas pour une image de %1 x %2 pixels</translation>
    </message>
    <message>
        <source>Writing the picture …</source>
        <translation>Export de l’image…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cell %1</source>
        <translation>Cellule %1</translation>
    </message>
    <message>
        <source>Writing the film …</source>
        <translation>Export du film…</translation>
    </message>
</context>
<context>
    <name>wend::SolidWorkshop</name>
    <message>
        <source>Solids need OpenGL 3.3, which this system does not have. The command line (wend run) still works with them.</source>
        <translation>Les solides demandent OpenGL 3.3, dont ce système ne dispose pas. La ligne de commande (wend run) fonctionne quand même avec eux.</translation>
    </message>
    <message>
        <source>These pictures of the surface cannot be read: %1</source>
        <translation>Impossible de lire ces images de la surface&#x202f;: %1</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>Exporté&#x202f;: %1</translation>
    </message>
    <message>
        <source>Nothing was written. %1</source>
        <translation>Rien n’a été exporté. %1</translation>
    </message>
    <message>
        <source>Region</source>
        <translation>Région</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Zone</translation>
    </message>
    <message>
        <source>The shape is still being computed. Try again in a moment.</source>
        <translation>La forme est encore en cours de calcul. Réessayez dans un instant.</translation>
    </message>
</context>
<context>
    <name>wend::SoundTrack</name>
    <message>
        <source>The sound is not shown: that needs the program ffmpeg (Debian: sudo apt install ffmpeg).</source>
        <translation>Le son n’est pas affiché : il y faut le programme ffmpeg (Debian : sudo apt install ffmpeg).</translation>
    </message>
    <message>
        <source>The sound %1 cannot be read: is the file there?</source>
        <translation>Le son %1 est illisible : le fichier est-il là ?</translation>
    </message>
</context>
<context>
    <name>wend::SpringOffer</name>
    <message>
        <source>What comes back leaves the shape a little different, so that a loop jumps. If the shape springs back fully, it is as it was.</source>
        <translation>Ce qui revient laisse la forme un peu différente, et une boucle saute. Si la forme revient entièrement, elle est comme avant.</translation>
    </message>
    <message>
        <source>Spring Back Fully</source>
        <translation>Revenir entièrement</translation>
    </message>
</context>
<context>
    <name>wend::StartPage</name>
    <message>
        <source>Pin a picture, pull it into shape, and let it flow.</source>
        <translation>Épinglez une image, tirez, et laissez-la prendre forme.</translation>
    </message>
    <message>
        <source>Drop a picture here</source>
        <translation>Déposez une image ici</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Choose a picture, a flat mesh or a project.</source>
        <translation>Choisir une image, un maillage plan ou un projet.</translation>
    </message>
    <message>
        <source>Try a sample</source>
        <translation>Essayer un exemple</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Five-minute tutorial</source>
        <translation>Tutoriel en cinq minutes</translation>
    </message>
    <message>
        <source>The first steps on a sample, one after another.</source>
        <translation>Les premiers pas sur un exemple, l’un après l’autre.</translation>
    </message>
    <message>
        <source>Not saved when Wend ended</source>
        <translation>Non enregistré à la fermeture de Wend</translation>
    </message>
    <message>
        <source>Discard…</source>
        <translation>Abandonner…</translation>
    </message>
    <message>
        <source>Discard %1</source>
        <translation>Abandonner %1</translation>
    </message>
    <message>
        <source>Deletes these changes for good.</source>
        <translation>Oublie ces modifications définitivement.</translation>
    </message>
    <message>
        <source>PNG, JPEG, TIFF, EXR, WebP … — cut-outs with transparency work best.
PSD, ORA, KRA and SVG with their layers. Projects, meshes and solids too.</source>
        <translation>PNG, JPEG, TIFF, EXR, WebP… — de préférence détourés, avec transparence.
PSD, ORA, KRA et SVG avec leurs calques. Projets, maillages et solides aussi.</translation>
    </message>
</context>
<context>
    <name>wend::StatusFields</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Where the pointer is, in the picture&apos;s pixels</source>
        <translation>Position du pointeur, en pixels de l’image</translation>
    </message>
    <message>
        <source>Area change</source>
        <translation>Variation d’aire</translation>
    </message>
    <message>
        <source>How much larger or smaller the shape is than at rest</source>
        <translation>De combien la forme est plus grande ou plus petite qu’au repos</translation>
    </message>
    <message>
        <source>area %1 %</source>
        <translation>aire %1&#x202f;%</translation>
    </message>
    <message>
        <source>volume %1 %</source>
        <translation>volume %1&#x202f;%</translation>
    </message>
</context>
<context>
    <name>wend::SurfaceCheck</name>
    <message>
        <source>Triangles with missing points</source>
        <translation>Triangles à points manquants</translation>
    </message>
    <message>
        <source>Triangles that cross</source>
        <translation>Triangles qui se croisent</translation>
    </message>
    <message>
        <source>Holes</source>
        <translation>Trous</translation>
    </message>
    <message>
        <source>Edges of more than two</source>
        <translation>Arêtes à plus de deux triangles</translation>
    </message>
    <message>
        <source>Triangles without area</source>
        <translation>Triangles sans aire</translation>
    </message>
    <message>
        <source>Duplicate triangles</source>
        <translation>Triangles en double</translation>
    </message>
    <message>
        <source>Turned neighbours</source>
        <translation>Voisins retournés</translation>
    </message>
    <message>
        <source>All points lie in one plane.</source>
        <translation>Tous les points sont dans un même plan.</translation>
    </message>
    <message>
        <source>Save List</source>
        <translation>Exporter la liste</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Texte (*.txt)</translation>
    </message>
    <message>
        <source>Repair surface</source>
        <translation>Réparer la surface</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>Créer une cage</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>Surface exacte seule</translation>
    </message>
    <message>
        <source>merge points (%1)</source>
        <translation>fusionner des points (%1)</translation>
    </message>
    <message>
        <source>drop triangles (%1)</source>
        <translation>supprimer des triangles (%1)</translation>
    </message>
    <message>
        <source>turn triangles (%1)</source>
        <translation>retourner des triangles (%1)</translation>
    </message>
    <message>
        <source>fill holes (%1)</source>
        <translation>boucher des trous (%1)</translation>
    </message>
    <message>
        <source>It would %1.</source>
        <translation>Opérations prévues&#x202f;: %1.</translation>
    </message>
    <message>
        <source>No simple step fixes this one.</source>
        <translation>Aucune étape simple ne corrige ce défaut.</translation>
    </message>
    <message>
        <source>add triangles (%1)</source>
        <translation>ajouter des triangles (%1)</translation>
    </message>
    <message>
        <source>It would leave %1 of %2 faults.</source>
        <translation>Il resterait %1 défauts sur %2.</translation>
    </message>
    <message>
        <source>Fix one fault</source>
        <translation>Corriger un défaut</translation>
    </message>
    <message>
        <source>No simple steps fix all of these.</source>
        <translation>Aucune étape simple ne les corrige tous.</translation>
    </message>
    <message>
        <source>Fix all faults of a kind</source>
        <translation>Corriger tous les défauts d’un type</translation>
    </message>
    <message>
        <source>Looking for what fixes all of these …</source>
        <translation>Recherche de ce qui les corrige tous…</translation>
    </message>
</context>
<context>
    <name>wend::SurfacePanel</name>
    <message>
        <source>Show them</source>
        <translation>Montrer</translation>
    </message>
    <message>
        <source>Save list…</source>
        <translation>Exporter la liste…</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>Réparer</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Ce qui ne va pas</translation>
    </message>
    <message>
        <source>The kinds of faults, and how often each occurs.</source>
        <translation>Les types de défauts, et combien de fois chacun se présente.</translation>
    </message>
    <message>
        <source>Previous place</source>
        <translation>Endroit précédent</translation>
    </message>
    <message>
        <source>Goes to the previous place where this is wrong.</source>
        <translation>Va à l’endroit précédent où ce défaut se trouve.</translation>
    </message>
    <message>
        <source>Next place</source>
        <translation>Endroit suivant</translation>
    </message>
    <message>
        <source>Goes to the next place where this is wrong.</source>
        <translation>Va à l’endroit suivant où ce défaut se trouve.</translation>
    </message>
    <message>
        <source>Show the triangles</source>
        <translation>Montrer les triangles</translation>
    </message>
    <message>
        <source>Colours the triangles that are wrong and shows them: what hides them is left out.</source>
        <translation>Colore les triangles défectueux et les montre&#x202f;: ce qui les cache est omis.</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>Exporter la liste</translation>
    </message>
    <message>
        <source>Writes the numbers of all wrong triangles and edges to a file.</source>
        <translation>Écrit dans un fichier les numéros de tous les triangles et arêtes défectueux.</translation>
    </message>
    <message>
        <source>Merges coincident points, drops degenerate and duplicate triangles, orients the others and fills small holes.</source>
        <translation>Fusionne les points confondus, supprime les triangles dégénérés et en double, les oriente et bouche les petits trous.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>The surface is embedded in a cage</source>
        <translation>La surface est portée par une cage</translation>
    </message>
    <message>
        <source>The surface bounds no solid</source>
        <translation>La surface n’enferme aucun solide</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>“Repair” helps.</source>
        <translation>«&#x202f;Réparer&#x202f;» suffit.</translation>
    </message>
    <message>
        <source>“Repair” does not help: a cage around it can carry it.</source>
        <translation>«&#x202f;Réparer&#x202f;» ne suffit pas&#x202f;: une cage autour d’elle peut la porter.</translation>
    </message>
    <message>
        <source>Exact surface only</source>
        <translation>Surface exacte seule</translation>
    </message>
    <message>
        <source>Fit a cage</source>
        <translation>Créer une cage</translation>
    </message>
    <message>
        <source>Removes the cage: without a repair there is then no solid.</source>
        <translation>Retire la cage&#x202f;: sans réparation, il n’y a alors plus de solide.</translation>
    </message>
    <message>
        <source>Fills a cage of even cells around the surface, which is embedded in it.</source>
        <translation>Remplit une cage de cellules uniformes autour de la surface, qu’elle entraîne.</translation>
    </message>
    <message>
        <source>See the repair</source>
        <translation>Aperçu</translation>
    </message>
    <message>
        <source>Shows the surface as the repair would leave it: what it adds in green, what stays wrong in red.</source>
        <translation>Montre la surface telle que la réparation la laisserait&#x202f;: en vert ce qu’elle ajoute, en rouge ce qui reste défectueux.</translation>
    </message>
    <message>
        <source>There is nothing that the simple repairs would change.</source>
        <translation>Il n’y a rien que les réparations simples changeraient.</translation>
    </message>
    <message>
        <source>Fix this one</source>
        <translation>Corriger celui-ci</translation>
    </message>
    <message>
        <source>Fixes only what is shown: what it adds is green, what it takes away or turns is yellow.</source>
        <translation>Ne corrige que ce qui est regardé&#x202f;: l’ajout est en vert, ce qui est retiré ou retourné en jaune.</translation>
    </message>
    <message>
        <source>Fix all</source>
        <translation>Tout corriger</translation>
    </message>
    <message>
        <source>Fixes all of this kind that simple steps can, as one step of undo; of the holes, those with no more edges than chosen below.</source>
        <translation>Corrige tous les défauts de ce type que des étapes simples corrigent, en une seule étape d’annulation&#x202f;; parmi les trous, ceux qui n’ont pas plus d’arêtes que choisi plus bas.</translation>
    </message>
    <message>
        <source>“Repair” does not help: the cage carries the surface as it is.</source>
        <translation>«&#x202f;Réparer&#x202f;» ne suffit pas&#x202f;: la cage porte la surface telle qu’elle est.</translation>
    </message>
    <message>
        <source>One hole has %1 edges: fill up to %1</source>
        <translation>Un trou a %1 arêtes : remplir jusqu’à %1</translation>
    </message>
    <message>
        <source>%1 holes have up to %2 edges: fill up to %2</source>
        <translation>%1 trous ont jusqu’à %2 arêtes : remplir jusqu’à %2</translation>
    </message>
    <message>
        <source>No hole is larger</source>
        <translation>Aucun trou n’est plus grand</translation>
    </message>
    <message>
        <source>Sets the largest hole that the repair fills to this.</source>
        <translation>Règle sur cette valeur le plus grand trou que la réparation remplit.</translation>
    </message>
</context>
<context>
    <name>wend::TimeRuler</name>
    <message>
        <source>Ruler</source>
        <translation>Règle</translation>
    </message>
    <message>
        <source>Drag to show another time; with Shift, mark the part that a loop repeats. A right-click counts frames, sets the frame rate, and adds markers</source>
        <translation>Glisser affiche un autre instant ; avec Maj, cela marque la partie qu’une boucle répète. Un clic droit compte les images, règle la cadence et ajoute des repères</translation>
    </message>
    <message>
        <source>Move marker</source>
        <translation>Déplacer le repère</translation>
    </message>
    <message>
        <source>Change cycle</source>
        <translation>Changer le cycle</translation>
    </message>
    <message>
        <source>Add marker</source>
        <translation>Ajouter un repère</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>Repère</translation>
    </message>
    <message>
        <source>Rename Marker</source>
        <translation>Renommer le repère</translation>
    </message>
    <message>
        <source>Name of the marker:</source>
        <translation>Nom du repère :</translation>
    </message>
    <message>
        <source>Rename marker</source>
        <translation>Renommer le repère</translation>
    </message>
    <message>
        <source>Frame &amp;Rate</source>
        <translation>Ca&amp;dence</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 i/s</translation>
    </message>
    <message>
        <source>Cycle &amp;from Here</source>
        <translation>Cycle à par&amp;tir d’ici</translation>
    </message>
    <message>
        <source>Cycle &amp;to Here</source>
        <translation>Cycle &amp;jusqu’ici</translation>
    </message>
    <message>
        <source>&amp;No Cycle</source>
        <translation>Aucu&amp;n cycle</translation>
    </message>
    <message>
        <source>Remove cycle</source>
        <translation>Retirer le cycle</translation>
    </message>
    <message>
        <source>&amp;Count Frames</source>
        <translation>&amp;Compter les images</translation>
    </message>
    <message>
        <source>Add &amp;Marker</source>
        <translation>Ajouter un repè&amp;re</translation>
    </message>
    <message>
        <source>R&amp;ename Marker…</source>
        <translation>R&amp;enommer le repère…</translation>
    </message>
    <message>
        <source>Re&amp;move Marker</source>
        <translation>Retirer &amp;le repère</translation>
    </message>
    <message>
        <source>Remove marker</source>
        <translation>Retirer le repère</translation>
    </message>
    <message>
        <source>Play the &amp;Sound</source>
        <translation>Jouer le &amp;son</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1 : %2</translation>
    </message>
    <message>
        <source>Cycle: %1 to %2</source>
        <translation>Cycle : %1 à %2</translation>
    </message>
    <message>
        <source>frames at %1 fps</source>
        <translation>images, %1 i/s</translation>
    </message>
    <message>
        <source>seconds</source>
        <translation>secondes</translation>
    </message>
    <message>
        <source>Show Key &amp;Poses</source>
        <translation>Montrer les &amp;poses clés</translation>
    </message>
</context>
<context>
    <name>wend::TimeScale</name>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
</context>
<context>
    <name>wend::TimeStrip</name>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Which moment of the motion is shown.</source>
        <translation>L’instant du mouvement qui est affiché.</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>How long the film is. The poses stay as they are, however fast it goes.</source>
        <translation>La durée du film. Les poses restent les mêmes, quelle que soit la vitesse.</translation>
    </message>
    <message>
        <source>Change length</source>
        <translation>Modifier la durée</translation>
    </message>
    <message>
        <source>Nothing moves yet: drag a pin.</source>
        <translation>Rien ne bouge encore&#x202f;: tirez une épingle.</translation>
    </message>
    <message>
        <source>%1 /</source>
        <translation>%1 /</translation>
    </message>
    <message>
        <source>Drag a pin to begin</source>
        <translation>Tirez une épingle pour commencer</translation>
    </message>
</context>
<context>
    <name>wend::Toolbox</name>
    <message>
        <source>Mesh</source>
        <translation>Maillage</translation>
    </message>
    <message>
        <source>What bends, and how finely</source>
        <translation>Ce qui se déforme, et avec quelle finesse</translation>
    </message>
    <message>
        <source>Pins</source>
        <translation>Épingles</translation>
    </message>
    <message>
        <source>Hold parts and drag them</source>
        <translation>Maintenir des parties et les tirer</translation>
    </message>
    <message>
        <source>Paint</source>
        <translation>Peindre</translation>
    </message>
    <message>
        <source>What it is made of: soft, stiff, and what is kept where</source>
        <translation>La matière&#x202f;: souple, raide, et ce qui est conservé à chaque endroit</translation>
    </message>
    <message>
        <source>Animate</source>
        <translation>Animer</translation>
    </message>
    <message>
        <source>How it moves in time</source>
        <translation>Comment cela bouge dans le temps</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exporter</translation>
    </message>
    <message>
        <source>Open a picture first.</source>
        <translation>Ouvrez d’abord une image.</translation>
    </message>
    <message>
        <source>Open a solid first.</source>
        <translation>Ouvrez d’abord un solide.</translation>
    </message>
    <message>
        <source>Write pictures, sequences, ST maps and meshes</source>
        <translation>Exporter images, séquences, cartes ST et maillages</translation>
    </message>
</context>
<context>
    <name>wend::TrackChoice</name>
    <message>
        <source>Move in time</source>
        <translation>Déplacer dans le temps</translation>
    </message>
    <message>
        <source>Remove motion</source>
        <translation>Supprimer le mouvement</translation>
    </message>
    <message>
        <source>Remove motions</source>
        <translation>Supprimer les mouvements</translation>
    </message>
    <message>
        <source>Change easing</source>
        <translation>Changer le lissage</translation>
    </message>
    <message>
        <source>Straighten</source>
        <translation>Redresser</translation>
    </message>
    <message>
        <source>Simplify</source>
        <translation>Simplifier</translation>
    </message>
    <message>
        <source>Move keys</source>
        <translation>Déplacer les clés</translation>
    </message>
    <message>
        <source>Move key</source>
        <translation>Déplacer la clé</translation>
    </message>
    <message>
        <source>Remove keys</source>
        <translation>Supprimer les clés</translation>
    </message>
    <message>
        <source>Remove key</source>
        <translation>Supprimer la clé</translation>
    </message>
    <message>
        <source>Paste keys</source>
        <translation>Coller les clés</translation>
    </message>
    <message>
        <source>Mirror keys</source>
        <translation>Mettre les clés en miroir</translation>
    </message>
    <message>
        <source>Hold</source>
        <translation>Tenir</translation>
    </message>
    <message>
        <source>Nothing changes: where a pin begins it is at rest, and rotations keep their course.</source>
        <translation>Rien ne change : là où une épingle commence, elle est au repos, et les rotations gardent leur cours.</translation>
    </message>
</context>
<context>
    <name>wend::TrackView</name>
    <message>
        <source>Rotate</source>
        <translation>Rotation</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Déplacement</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Path</source>
        <translation>Trajectoire</translation>
    </message>
    <message>
        <source>Tracks</source>
        <translation>Pistes</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Déplacer dans le temps</translation>
    </message>
    <message>
        <source>Change duration</source>
        <translation>Changer la durée</translation>
    </message>
    <message>
        <source>&amp;Remove Motion</source>
        <translation>&amp;Supprimer le mouvement</translation>
    </message>
    <message>
        <source>Nothing moves yet. Drag a pin, or record it with Ctrl held: what you do appears here, pin by pin.</source>
        <translation>Rien ne bouge encore. Tirez une épingle, ou enregistrez-la avec Ctrl&#x202f;: vos gestes seront ici, épingle par épingle.</translation>
    </message>
    <message>
        <source>Change when it holds</source>
        <translation>Changer quand elle tient</translation>
    </message>
    <message>
        <source>&amp;Remove Motions</source>
        <translation>&amp;Supprimer les mouvements</translation>
    </message>
    <message>
        <source>Easing</source>
        <translation>Lissage</translation>
    </message>
    <message>
        <source>&amp;Paste at the Time Shown</source>
        <translation>C&amp;oller à l’instant affiché</translation>
    </message>
    <message>
        <source>Paste M&amp;irrored</source>
        <translation>Coller en m&amp;iroir</translation>
    </message>
    <message>
        <source>&amp;Straighten</source>
        <translation>Re&amp;dresser</translation>
    </message>
    <message>
        <source>Simplify to &amp;Keys</source>
        <translation>Simplifier en &amp;clés</translation>
    </message>
    <message>
        <source>&amp;Few</source>
        <translation>&amp;Peu</translation>
    </message>
    <message>
        <source>&amp;Some</source>
        <translation>&amp;Quelques-unes</translation>
    </message>
    <message>
        <source>&amp;Many</source>
        <translation>&amp;Beaucoup</translation>
    </message>
    <message>
        <source>Key at %1</source>
        <translation>Clé : %1</translation>
    </message>
    <message>
        <source>Holds from %1 to %2</source>
        <translation>Tient de %1 à %2</translation>
    </message>
    <message>
        <source>%1: %2 to %3, %4</source>
        <translation>%1 : %2 à %3, %4</translation>
    </message>
    <message>
        <source>&amp;Linear</source>
        <translation>&amp;Linéaire</translation>
    </message>
    <message>
        <source>Slow &amp;before It</source>
        <translation>Lent a&amp;vant</translation>
    </message>
    <message>
        <source>Slow &amp;after It</source>
        <translation>Lent &amp;après</translation>
    </message>
    <message>
        <source>Slow on B&amp;oth Sides</source>
        <translation>Lent des deu&amp;x côtés</translation>
    </message>
    <message>
        <source>&amp;Hold to the Next</source>
        <translation>Tenir &amp;jusqu’à la suivante</translation>
    </message>
    <message>
        <source>&amp;Mirror</source>
        <translation>Mettre en &amp;miroir</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Copier</translation>
    </message>
    <message>
        <source>&amp;Remove Keys</source>
        <translation>&amp;Supprimer les clés</translation>
    </message>
    <message>
        <source>&amp;Remove Key</source>
        <translation>&amp;Supprimer la clé</translation>
    </message>
    <message>
        <source>A row for each pin, with a bar for each of its motions; Up and Down choose a pin, Left and Right another time, with Alt they move the chosen bar or keys</source>
        <translation>Une ligne par épingle, une barre par mouvement ; Haut et Bas choisissent une épingle, Gauche et Droite un autre instant, avec Alt ils déplacent la barre ou les clés choisies</translation>
    </message>
    <message>
        <source>Drag a key (a diamond) or a bar to another time; Shift, Ctrl or a frame around them choose several. A right-click eases, holds, copies, mirrors. The ends of the line show when the pin holds</source>
        <translation>Glissez une clé (un losange) ou une barre vers un autre instant ; Maj, Ctrl ou un cadre autour d’elles en choisit plusieurs. Un clic droit lisse, tient, copie, met en miroir. Les extrémités de la ligne disent quand l’épingle tient</translation>
    </message>
    <message>
        <source>Easing Curve</source>
        <translation>Courbe de lissage</translation>
    </message>
    <message>
        <source>Easing C&amp;urve…</source>
        <translation>Co&amp;urbe de lissage…</translation>
    </message>
</context>
<context>
    <name>wend::Tutorial</name>
    <message>
        <source>End</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Ends the tutorial; the picture stays open</source>
        <translation>Arrête le tutoriel&#x202f;; l’image reste ouverte</translation>
    </message>
    <message>
        <source>Only what is pinned holds. &lt;b&gt;Click a hoof&lt;/b&gt; of the giraffe to pin it.</source>
        <translation>Seul ce qui est épinglé reste en place. &lt;b&gt;Cliquez sur un sabot&lt;/b&gt; de la girafe pour l’épingler.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Pin the other hooves&lt;/b&gt;, too, with a click each. Ctrl+Z undoes a pin.</source>
        <translation>&lt;b&gt;Épinglez aussi les autres sabots&lt;/b&gt;, un clic pour chacun. Ctrl+Z reprend une épingle.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Click its nose&lt;/b&gt;, and &lt;b&gt;drag the new pin&lt;/b&gt; down to the ground. The shape flows along.</source>
        <translation>&lt;b&gt;Cliquez sur son museau&lt;/b&gt;, puis &lt;b&gt;tirez la nouvelle épingle&lt;/b&gt; jusqu’au sol. La forme suit en souplesse.</translation>
    </message>
    <message>
        <source>What it keeps on the way is your choice: at the top right, under &lt;b&gt;Keep&lt;/b&gt;, &lt;b&gt;choose Area, Rigid or Angle&lt;/b&gt;, and see the neck change.</source>
        <translation>Ce qu’elle conserve en chemin, c’est vous qui le choisissez&#x202f;: en haut à droite, sous &lt;b&gt;Conserver&lt;/b&gt;, &lt;b&gt;choisissez Aire, Rigide ou Angle&lt;/b&gt;, et voyez le cou changer.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Press D&lt;/b&gt; to see in colours what the bend has changed, and where most. D again hides it.</source>
        <translation>&lt;b&gt;Appuyez sur D&lt;/b&gt; pour voir en couleurs ce que la déformation a changé, et où le plus. D de nouveau le masque.</translation>
    </message>
    <message>
        <source>The same for a part only: &lt;b&gt;press Ctrl+3&lt;/b&gt; for the step &lt;i&gt;Paint&lt;/i&gt;, and &lt;b&gt;brush over the neck&lt;/b&gt;. [ and ] change the size of the brush.</source>
        <translation>La même chose pour une partie seulement&#x202f;: &lt;b&gt;appuyez sur Ctrl+3&lt;/b&gt; pour l’étape &lt;i&gt;Peindre&lt;/i&gt;, et &lt;b&gt;passez le pinceau sur le cou&lt;/b&gt;. [ et ] changent la taille du pinceau.</translation>
    </message>
    <message>
        <source>Your drag is already a film: &lt;b&gt;press K&lt;/b&gt; to play it. Click into the strip below to go to a time, and drag on from there.</source>
        <translation>Votre geste est déjà un film&#x202f;: &lt;b&gt;appuyez sur K&lt;/b&gt; pour le lire. Cliquez dans la bande du bas pour aller à un instant, et continuez à tirer à partir de là.</translation>
    </message>
    <message>
        <source>That is all you need to begin. &lt;b&gt;F1&lt;/b&gt; opens the manual, &lt;b&gt;?&lt;/b&gt; lists the keys. Drop a picture of your own on the window.</source>
        <translation>C’est tout ce qu’il faut pour commencer. &lt;b&gt;F1&lt;/b&gt; ouvre le manuel, &lt;b&gt;?&lt;/b&gt; liste les touches. Déposez une de vos images sur la fenêtre.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Finally, &lt;b&gt;press Ctrl+5&lt;/b&gt; for the step &lt;i&gt;Export&lt;/i&gt;: a picture, a sequence, an ST map, or the mesh.</source>
        <translation>Enfin, &lt;b&gt;appuyez sur Ctrl+5&lt;/b&gt; pour l’étape &lt;i&gt;Exporter&lt;/i&gt; : une image, une séquence, une carte ST ou le maillage.</translation>
    </message>
</context>
<context>
    <name>wend::VolumeView</name>
    <message>
        <source>View of the solid</source>
        <translation>Vue du solide</translation>
    </message>
    <message>
        <source>The solid cannot be drawn: %1</source>
        <translation>Impossible de dessiner le solide&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>wend::WorkNote</name>
    <message>
        <source>Cancel (Esc)</source>
        <translation>Annuler (Échap)</translation>
    </message>
    <message>
        <source>Stops what is being computed and goes back to the last complete state</source>
        <translation>Arrête le calcul en cours et revient au dernier état complet</translation>
    </message>
    <message>
        <source>Computing the motion: %1 %</source>
        <translation>Calcul du mouvement&#x202f;: %1&#x202f;%</translation>
    </message>
    <message>
        <source>Meshing %1 …</source>
        <translation>Maillage de %1…</translation>
    </message>
    <message numerus="yes">
        <source>Meshing %1 with about %Ln vertices …</source>
        <translation>
            <numerusform>Maillage de %1 avec environ %Ln sommet…</numerusform>
            <numerusform>Maillage de %1 avec environ %Ln sommets…</numerusform>
        </translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Progression</translation>
    </message>
    <message>
        <source>Filling the ground behind “%1” …</source>
        <translation>Remplissage du fond derrière « %1 »…</translation>
    </message>
</context>
</TS>
