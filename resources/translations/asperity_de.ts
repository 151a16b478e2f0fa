<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>Words</name>
    <message>
        <source>tangential force F</source>
        <translation>Tangentialkraft F</translation>
    </message>
    <message>
        <source>tangential force in total F</source>
        <translation>Tangentialkraft gesamt F</translation>
    </message>
    <message>
        <source>total F</source>
        <translation>gesamt F</translation>
    </message>
    <message>
        <source>Tangential force divided by normal force while the elastomer still relaxes after a change, read from the time steps since the last picture.</source>
        <translation>Tangentialkraft geteilt durch Normalkraft, während das Elastomer nach einer Änderung noch relaxiert, abgelesen aus den Zeitschritten seit dem letzten Bild.</translation>
    </message>
    <message>
        <source>Tangential force divided by normal force at this moment of the motion, a mean over the time since the last picture. After ± stands the estimated error of elements and time steps.</source>
        <translation>Tangentialkraft geteilt durch Normalkraft in diesem Augenblick der Bewegung, im Mittel über die Zeit seit dem letzten Bild. Nach ± steht der geschätzte Fehler durch Elemente und Zeitschritte.</translation>
    </message>
    <message>
        <source>Tangential force divided by normal force of this line in steady sliding, computed without time steps.</source>
        <translation>Tangentialkraft geteilt durch Normalkraft dieser Linie bei stationärem Gleiten, ohne Zeitschritte berechnet.</translation>
    </message>
    <message>
        <source>A rough rigid line</source>
        <translation>Eine raue starre Linie</translation>
    </message>
    <message>
        <source>A flat rigid line</source>
        <translation>Eine ebene starre Linie</translation>
    </message>
    <message>
        <source>A rigid sine</source>
        <translation>Ein starrer Sinus</translation>
    </message>
    <message>
        <source>A rigid wedge</source>
        <translation>Ein starrer Keil</translation>
    </message>
    <message>
        <source>A rigid parabola</source>
        <translation>Eine starre Parabel</translation>
    </message>
    <message>
        <source>A measured rigid line</source>
        <translation>Eine gemessene starre Linie</translation>
    </message>
    <message>
        <source>A rigid line</source>
        <translation>Eine starre Linie</translation>
    </message>
    <message>
        <source>A rigid line on an elastomer</source>
        <translation>Eine starre Linie auf einem Elastomer</translation>
    </message>
    <message>
        <source>%1 rests on an elastomer</source>
        <translation>%1 ruht auf einem Elastomer</translation>
    </message>
    <message>
        <source>%1 slides over an elastomer</source>
        <translation>%1 gleitet über ein Elastomer</translation>
    </message>
    <message>
        <source>t = %1, displaced by %2</source>
        <translation>t = %1; verschoben um %2</translation>
    </message>
    <message>
        <source>t = %1, slid %2</source>
        <translation>t = %1; Weg %2</translation>
    </message>
    <message>
        <source>elastic, G = %1</source>
        <translation>elastisch, G = %1</translation>
    </message>
    <message>
        <source>viscoelastic, G = %1, τ = %2</source>
        <translation>viskoelastisch, G = %1, τ = %2</translation>
    </message>
    <message>
        <source>viscoelastic, G = %1, τ = %2 at %3</source>
        <translation>viskoelastisch, G = %1, τ = %2 bei %3</translation>
    </message>
    <message>
        <source>viscoelastic, G∞ = %1, %2 arm</source>
        <translation>viskoelastisch, G∞ = %1, %2 Arm</translation>
    </message>
    <message>
        <source>viscoelastic, G∞ = %1, %2 arms</source>
        <translation>viskoelastisch, G∞ = %1, %2 Arme</translation>
    </message>
    <message>
        <source>nothing is dissipated</source>
        <translation>nichts wird dissipiert</translation>
    </message>
    <message>
        <source>%1 total, %2 % in the free surface</source>
        <translation>%1 insgesamt, %2 % in der freien Oberfläche</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>to scale</source>
        <translation>maßstäblich</translation>
    </message>
    <message>
        <source>heights reduced %1×</source>
        <translation>Höhen gestaucht, %1-fach</translation>
    </message>
    <message>
        <source>vertical exaggeration %1×</source>
        <translation>%1-fach überhöht</translation>
    </message>
    <message>
        <source>no colours: the contact is too small to be drawn</source>
        <translation>keine Farben: Der Kontakt ist zu klein zum Zeichnen</translation>
    </message>
    <message>
        <source>no colours: nothing touches</source>
        <translation>keine Farben: nichts berührt sich</translation>
    </message>
    <message>
        <source>no colours: nothing is dissipated at rest</source>
        <translation>keine Farben: in Ruhe wird nichts dissipiert</translation>
    </message>
    <message>
        <source>no colours: nothing is dissipated</source>
        <translation>keine Farben: nichts wird dissipiert</translation>
    </message>
    <message>
        <source>no colours: all of the surface is in contact</source>
        <translation>keine Farben: die ganze Oberfläche ist in Kontakt</translation>
    </message>
    <message>
        <source>no colours: at rest nothing leaves contact</source>
        <translation>keine Farben: in Ruhe verlässt nichts den Kontakt</translation>
    </message>
    <message>
        <source>no colours: nothing has left contact yet</source>
        <translation>keine Farben: noch nichts hat den Kontakt verlassen</translation>
    </message>
    <message>
        <source>coefficient of friction</source>
        <translation>Reibungszahl</translation>
    </message>
    <message>
        <source>coefficient of friction at the end, of the line shown</source>
        <translation>Reibungszahl der gezeigten Linie am Ende</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>in Kontakt</translation>
    </message>
    <message>
        <source>indentation</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>%1 (line shown: %2)</source>
        <translation>%1 (gezeigte Linie: %2)</translation>
    </message>
    <message>
        <source>coefficient of friction, mean of %1 lines</source>
        <translation>Reibungszahl, Mittel über %1 Linien</translation>
    </message>
    <message>
        <source>One scene, and it failed.</source>
        <translation>Eine Szene, und sie ist fehlgeschlagen.</translation>
    </message>
    <message>
        <source>One scene.</source>
        <translation>Eine Szene.</translation>
    </message>
    <message>
        <source>%1 scenes, %2 of them failed.</source>
        <translation>%1 Szenen, davon %2 fehlgeschlagen.</translation>
    </message>
    <message>
        <source>%1 scenes.</source>
        <translation>%1 Szenen.</translation>
    </message>
    <message>
        <source>All on one sheet</source>
        <translation>Alle auf einem Blatt</translation>
    </message>
    <message>
        <source>Sheet %1</source>
        <translation>Blatt %1</translation>
    </message>
    <message>
        <source>all results as a table</source>
        <translation>alle Ergebnisse als Tabelle</translation>
    </message>
    <message>
        <source>Made by Asperity %1.</source>
        <translation>Erstellt mit Asperity %1.</translation>
    </message>
    <message>
        <source>difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>(extrapolated)</source>
        <translation>(extrapoliert)</translation>
    </message>
    <message>
        <source>best for its time</source>
        <translation>am besten für seine Zeit</translation>
    </message>
    <message>
        <source>&lt;- this scene</source>
        <translation>&lt;- diese Szene</translation>
    </message>
    <message>
        <source>a march in time: half the step changes friction by %1 %</source>
        <translation>Zeitschritte: Der halbe Schritt ändert die Reibung um %1 %</translation>
    </message>
    <message>
        <source>, settling by %1 %</source>
        <translation>; das Einschwingen um %1 %</translation>
    </message>
    <message>
        <source>region %1, %2 to %3 m/s</source>
        <translation>Bereich %1, %2 bis %3 m/s</translation>
    </message>
    <message>
        <source>a valid scene</source>
        <translation>eine gültige Szene</translation>
    </message>
    <message>
        <source>line: L = %1, %2 elements of %3, rms height %4, rms slope %5</source>
        <translation>Linie: L = %1; %2 Elemente zu %3; RMS-Höhe %4; RMS-Steigung %5</translation>
    </message>
    <message>
        <source>dimensionless force F_N / G h L = %1 (Eq. 14)</source>
        <translation>dimensionslose Kraft F_N / G h L = %1 (Gl. 14)</translation>
    </message>
    <message>
        <source>dimensionless velocity τ v ∇z / (√2 h) = %1 (Eq. 13)</source>
        <translation>dimensionslose Geschwindigkeit τ v ∇z / (√2 h) = %1 (Gl. 13)</translation>
    </message>
    <message>
        <source>one velocity</source>
        <translation>eine Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 velocities</source>
        <translation>%1 Geschwindigkeiten</translation>
    </message>
    <message>
        <source>one realization</source>
        <translation>eine Realisierung</translation>
    </message>
    <message>
        <source>%1 realizations</source>
        <translation>%1 Realisierungen</translation>
    </message>
    <message>
        <source>%1 % of the balances with a partly loaded element</source>
        <translation>%1 % der Gleichgewichte mit einem teilweise belasteten Element</translation>
    </message>
    <message>
        <source>relative error at most %1 at every velocity, target met</source>
        <translation>relativer Fehler bei jeder Geschwindigkeit höchstens %1; Ziel erreicht</translation>
    </message>
    <message>
        <source>relative error at most %1 at every velocity, target not met</source>
        <translation>relativer Fehler bei jeder Geschwindigkeit höchstens %1; Ziel nicht erreicht</translation>
    </message>
    <message>
        <source>at %1 velocities friction is below what the elements resolve, see the column notes</source>
        <translation>bei %1 Geschwindigkeiten liegt die Reibung unter dem, was die Elemente auflösen, siehe Spalte notes</translation>
    </message>
    <message>
        <source>at one velocity friction is below what the elements resolve, see the column notes</source>
        <translation>bei einer Geschwindigkeit liegt die Reibung unter dem, was die Elemente auflösen, siehe Spalte notes</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1 % of the run time</source>
        <translation>%1 % der Laufzeit</translation>
    </message>
    <message>
        <source>%1 rows of each of %2 lines</source>
        <translation>%1 Zeilen von jeder der %2 Linien</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>estimated error of mu by elements and time steps %1 (%2 %)</source>
        <translation>geschätzter Fehler von μ durch Elemente und Zeitschritte %1 (%2 %)</translation>
    </message>
    <message>
        <source>one was there already</source>
        <translation>eines war schon da</translation>
    </message>
    <message>
        <source>%1 were there already</source>
        <translation>%1 waren schon da</translation>
    </message>
    <message>
        <source>removed one frame that an earlier, longer sequence left</source>
        <translation>ein Bild entfernt, das von einer früheren, längeren Folge übrig war</translation>
    </message>
    <message>
        <source>removed %1 frames that an earlier, longer sequence left</source>
        <translation>%1 Bilder entfernt, die von einer früheren, längeren Folge übrig waren</translation>
    </message>
    <message>
        <source>wrote one frame to %1</source>
        <translation>Ein Bild geschrieben in %1</translation>
    </message>
    <message>
        <source>wrote one frame in %1</source>
        <translation>Ein Bild geschrieben nach %1</translation>
    </message>
    <message>
        <source>wrote %1 frames to %2</source>
        <translation>%1 Bilder geschrieben in %2</translation>
    </message>
    <message>
        <source>wrote %1 frames in %2</source>
        <translation>%1 Bilder geschrieben nach %2</translation>
    </message>
    <message>
        <source>length %1, %2 points, rms height %3, rms slope %4</source>
        <translation>Länge %1; %2 Punkte; RMS-Höhe %3; RMS-Steigung %4</translation>
    </message>
    <message>
        <source>, </source>
        <translation>; </translation>
    </message>
    <message>
        <source>resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>standard error</source>
        <translation>Standardfehler</translation>
    </message>
    <message>
        <source>force balance</source>
        <translation>Kräftegleichgewicht</translation>
    </message>
    <message>
        <source>time step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>settling</source>
        <translation>Einschwingen</translation>
    </message>
    <message>
        <source>%1; differs from the resolved line by %2</source>
        <translation>%1; weicht von der aufgelösten Linie um %2 ab</translation>
    </message>
    <message>
        <source>%1 steps of %2 elements, without drawing</source>
        <translation>%1 Schritte mit %2 Elementen; ohne Zeichnen</translation>
    </message>
    <message>
        <source>%1 simulations</source>
        <translation>%1 Simulationen</translation>
    </message>
    <message>
        <source>one thread</source>
        <translation>einem Thread</translation>
    </message>
    <message>
        <source>%1 threads</source>
        <translation>%1 Threads</translation>
    </message>
    <message>
        <source>no %1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>asperity %1 runs</source>
        <translation>asperity %1 führt aus</translation>
    </message>
    <message>
        <source>and leaves out</source>
        <translation>und lässt aus</translation>
    </message>
    <message>
        <source>above %1 few contacts carry the load (region IV): F_N / (4 eta v), the sum of the heights climbed by all contacts of one period, is below 0.1 h; the border belongs to the finite period and moves with it</source>
        <translation>über %1 tragen wenige Kontakte die Last (Bereich IV): F_N / (4 eta v), die Summe der Höhen, die alle Kontakte einer Periode erklimmen, liegt unter 0,1 h; die Grenze gehört zur endlichen Periode und wandert mit ihr</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>vorhergesagt</translation>
    </message>
    <message>
        <source>%1 on %2 (%3)</source>
        <translation>%1 mit %2 (%3)</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>%1 more than before</source>
        <translation>%1 mehr als zuvor</translation>
    </message>
    <message>
        <source>wrote %1</source>
        <translation>geschrieben: %1</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>roh</translation>
    </message>
    <message>
        <source>used</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>F_N = %1 on one period of %2, which is twice the file&apos;s; F_N / L = %3</source>
        <translation>F_N = %1 auf eine Periode von %2, die zweimal die der Datei ist; F_N / L = %3</translation>
    </message>
    <message>
        <source>F_N = %1 on one period of %2; F_N / L = %3</source>
        <translation>F_N = %1 auf eine Periode von %2; F_N / L = %3</translation>
    </message>
    <message>
        <source>%1 times %2 states, %3 of them different</source>
        <translation>%1 mal %2 Zustände, davon %3 verschiedene</translation>
    </message>
    <message>
        <source>friction does not depend on %1 in this scene</source>
        <translation>die Reibung hängt in dieser Szene nicht von %1 ab</translation>
    </message>
    <message>
        <source>one value of %1</source>
        <translation>ein Wert von %1</translation>
    </message>
    <message>
        <source>%1 values of %2</source>
        <translation>%1 Werte von %2</translation>
    </message>
    <message>
        <source>%1 simulations of %2 states on %3 lines each, in chunks of %4</source>
        <translation>%1 Simulationen zu %2 Zuständen auf je %3 Linien, in Blöcken von %4</translation>
    </message>
    <message>
        <source>%1 of them are done</source>
        <translation>%1 davon sind fertig</translation>
    </message>
    <message>
        <source>about %1 on %2 threads, by a trial of %3 simulations</source>
        <translation>etwa %1 mit %2 Threads, nach einem Versuch mit %3 Simulationen</translation>
    </message>
    <message>
        <source>%1 of the trial cannot be computed</source>
        <translation>%1 aus dem Versuch lassen sich nicht berechnen</translation>
    </message>
    <message>
        <source>about %1 MB in the store</source>
        <translation>etwa %1 MB im Speicher</translation>
    </message>
    <message>
        <source>%1 of %2 simulations done, %3 of them now</source>
        <translation>%1 von %2 Simulationen fertig, %3 davon jetzt</translation>
    </message>
    <message>
        <source>other processes work on the rest</source>
        <translation>andere Prozesse arbeiten am Rest</translation>
    </message>
    <message>
        <source>%1 minutes, %2 steps, %3 predictions</source>
        <translation>%1 Minuten, %2 Schritte, %3 Vorhersagen</translation>
    </message>
    <message>
        <source>%1 times %2 states, %3 of them different, on %4 lines each</source>
        <translation>%1 mal %2 Zustände, davon %3 verschiedene, auf je %4 Linien</translation>
    </message>
    <message>
        <source>%1 times %2 states on %3 lines each</source>
        <translation>%1 mal %2 Zustände auf je %3 Linien</translation>
    </message>
    <message>
        <source>the map</source>
        <translation>die Karte</translation>
    </message>
    <message>
        <source>height above the undeformed surface</source>
        <translation>Höhe über der unverformten Oberfläche</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>%1, another version</source>
        <translation>%1, eine andere Fassung</translation>
    </message>
</context>
<context>
    <name>asperity::AccuracyPanel</name>
    <message>
        <source>measuring every method on this scene&apos;s lines …</source>
        <translation>Jedes Verfahren wird auf den Linien dieser Szene gemessen…</translation>
    </message>
    <message>
        <source>quick</source>
        <translation>schnell</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>genau</translation>
    </message>
    <message>
        <source>accuracy from quick to exact</source>
        <translation>Genauigkeit von schnell bis genau</translation>
    </message>
    <message>
        <source>No target</source>
        <translation>Kein Ziel</translation>
    </message>
    <message>
        <source>Scheme, oversampling and realizations as set in the parameters</source>
        <translation>Verfahren, Überabtastung und Realisierungen nach den Parametern</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Compare methods</source>
        <translation>Verfahren vergleichen</translation>
    </message>
    <message>
        <source>Measures error against time of every method on this scene&apos;s lines</source>
        <translation>Misst Fehler über Zeit jedes Verfahrens auf den Linien dieser Szene</translation>
    </message>
    <message>
        <source>target: %1 of μ at every velocity</source>
        <translation>Ziel: %1 von μ bei jeder Geschwindigkeit</translation>
    </message>
    <message>
        <source>no target: scheme and realizations as set</source>
        <translation>kein Ziel: Verfahren und Linien wie gewählt</translation>
    </message>
    <message>
        <source>predicting …</source>
        <translation>Vorhersage läuft…</translation>
    </message>
    <message>
        <source>“Compare methods” measures what accuracy costs for this scene.</source>
        <translation>„Verfahren vergleichen“ misst, was Genauigkeit bei dieser Szene kostet.</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>Cancel (%1 %)</source>
        <translation>Abbrechen (%1 %)</translation>
    </message>
    <message>
        <source>Measured is the time on the clock from the change of the scene to its whole curve. Other programs that run meanwhile make it longer than predicted.</source>
        <translation>Gemessen ist die Laufzeit von der Änderung der Szene bis zu ihrer ganzen Kurve. Andere Programme, die zugleich laufen, machen sie länger als vorhergesagt.</translation>
    </message>
    <message>
        <source>measured: %1 on the clock, error of the whole curve %2</source>
        <translation>gemessen: %1 Laufzeit, Fehler der ganzen Kurve %2</translation>
    </message>
    <message>
        <source>measured: %1 on the clock, standard error of the whole curve %2</source>
        <translation>gemessen: %1 Laufzeit, Standardfehler der ganzen Kurve %2</translation>
    </message>
    <message>
        <source>predicted motion: %1 on free processors for %2 steps, error of the whole motion %3 (time step %4, resolution %5, settling %6)</source>
        <translation>vorhergesagte Bewegung: %1 auf freien Prozessoren für %2 Schritte, Fehler der ganzen Bewegung %3 (Zeitschritt %4, Auflösung %5, Einschwingen %6)</translation>
    </message>
    <message>
        <source>predicted: %1 on free processors, error of the whole curve %2 (resolution %3, standard error %4)</source>
        <translation>vorhergesagt: %1 auf freien Prozessoren, Fehler der ganzen Kurve %2 (Auflösung %3, Standardfehler %4)</translation>
    </message>
</context>
<context>
    <name>asperity::Appearance</name>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>Farbschema</translation>
    </message>
    <message>
        <source>Same as system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
</context>
<context>
    <name>asperity::ArmsEditor</name>
    <message>
        <source>modulus of arm %1</source>
        <translation>Modul von Arm %1</translation>
    </message>
    <message>
        <source>relaxation time of arm %1</source>
        <translation>Relaxationszeit von Arm %1</translation>
    </message>
    <message>
        <source>Remove this arm</source>
        <translation>Diesen Arm entfernen</translation>
    </message>
    <message>
        <source>remove arm %1</source>
        <translation>Arm %1 entfernen</translation>
    </message>
    <message>
        <source>modulus</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>relaxation time</source>
        <translation>Relaxationszeit</translation>
    </message>
    <message>
        <source>Add arm</source>
        <translation>Arm hinzufügen</translation>
    </message>
    <message>
        <source>One more arm, with ten times the longest relaxation time</source>
        <translation>Ein weiterer Arm mit der zehnfachen längsten Relaxationszeit</translation>
    </message>
    <message>
        <source>arms: %1</source>
        <translation>Arme: %1</translation>
    </message>
    <message>
        <source>clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>Paste table</source>
        <translation>Tabelle einfügen</translation>
    </message>
    <message>
        <source>Two columns from the clipboard, as a spreadsheet copies them, replace all arms: modulus in Pa and relaxation time in s, or as names and units in the first row say</source>
        <translation>Zwei Spalten aus der Zwischenablage, wie eine Tabellenkalkulation sie kopiert, ersetzen alle Arme: Modul in Pa und Relaxationszeit in s, oder wie Namen und Einheiten in der ersten Zeile sagen</translation>
    </message>
    <message>
        <source>one</source>
        <translation>einer</translation>
    </message>
</context>
<context>
    <name>asperity::AssignmentList</name>
    <message>
        <source>Change a parameter…</source>
        <translation>Parameter ändern…</translation>
    </message>
    <message>
        <source>Removes this change</source>
        <translation>Entfernt diese Änderung</translation>
    </message>
    <message>
        <source>remove the change of “%1”</source>
        <translation>die Änderung von „%1“ entfernen</translation>
    </message>
    <message>
        <source>Allowed: %1</source>
        <translation>Erlaubt: %1</translation>
    </message>
</context>
<context>
    <name>asperity::AxisChoosers</name>
    <message>
        <source>horizontal axis</source>
        <translation>waagerechte Achse</translation>
    </message>
    <message>
        <source>What the curve goes over: any number that changes friction in this scene. The marker then sets it.</source>
        <translation>Worüber die Kurve geht: jede Zahl, die in dieser Szene die Reibung ändert. Die Markierung stellt sie dann ein.</translation>
    </message>
    <message>
        <source>vertical axis</source>
        <translation>senkrechte Achse</translation>
    </message>
    <message>
        <source>What the curve shows</source>
        <translation>Was die Kurve zeigt</translation>
    </message>
    <message>
        <source>Dimensionless velocity v̄, Eq. (13)</source>
        <translation>Dimensionslose Geschwindigkeit v̄, Gl. (13)</translation>
    </message>
    <message>
        <source>Dimensionless: μ over the rms slope against v̄</source>
        <translation>Dimensionslos: μ durch die RMS-Steigung über v̄</translation>
    </message>
</context>
<context>
    <name>asperity::ChartLegend</name>
    <message>
        <source>legend of the chart</source>
        <translation>Legende des Diagramms</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Click to unpin this curve</source>
        <translation>Klicken, um diese Kurve zu lösen</translation>
    </message>
</context>
<context>
    <name>asperity::ClaimsTable</name>
    <message>
        <source>Computed: %1.</source>
        <translation>Berechnet: %1.</translation>
    </message>
    <message>
        <source>Holds when: %1.</source>
        <translation>Gilt, wenn: %1.</translation>
    </message>
    <message>
        <source>Undecided: within two standard errors of that border, or without a standard error.</source>
        <translation>Unentschieden: höchstens zwei Standardfehler neben dieser Grenze oder ohne Standardfehler.</translation>
    </message>
    <message>
        <source>what the paper says about this figure, and whether it holds</source>
        <translation>was die Arbeit zu dieser Abbildung sagt und ob es gilt</translation>
    </message>
    <message>
        <source>Holds</source>
        <translation>Gilt</translation>
    </message>
    <message>
        <source>The paper says</source>
        <translation>Aussage der Arbeit</translation>
    </message>
    <message>
        <source>Computed</source>
        <translation>Berechnet</translation>
    </message>
    <message>
        <source>Expected</source>
        <translation>Erwartet</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Stelle</translation>
    </message>
</context>
<context>
    <name>asperity::CommandRun</name>
    <message>
        <source>The program %1 cannot be started</source>
        <translation>Das Programm %1 kann nicht gestartet werden</translation>
    </message>
    <message>
        <source>The program ended without a reason</source>
        <translation>Das Programm endete ohne Angabe eines Grundes</translation>
    </message>
</context>
<context>
    <name>asperity::ComparisonBox</name>
    <message>
        <source>Compare the curve with</source>
        <translation>Kurve vergleichen mit</translation>
    </message>
    <message>
        <source>Compare the curve (only without a target accuracy)</source>
        <translation>Kurve vergleichen (nur ohne Zielgenauigkeit)</translation>
    </message>
    <message>
        <source>Computes the curve in this way, too, on the same lines, and plots the difference below it</source>
        <translation>Berechnet die Kurve auf denselben Linien auch auf diese Weise und zeigt den Unterschied darunter</translation>
    </message>
    <message>
        <source>scheme to compare with</source>
        <translation>Verfahren zum Vergleich</translation>
    </message>
    <message>
        <source>points per element to compare with</source>
        <translation>Punkte je Element zum Vergleich</translation>
    </message>
    <message>
        <source>lines to compare with</source>
        <translation>Linien zum Vergleich</translation>
    </message>
    <message>
        <source> line</source>
        <translation> Linie</translation>
    </message>
    <message>
        <source> lines</source>
        <translation> Linien</translation>
    </message>
</context>
<context>
    <name>asperity::ComparisonCommands</name>
    <message>
        <source>Fit…</source>
        <translation>Anpassen…</translation>
    </message>
    <message>
        <source>Fit parameters of the scene to the measured friction</source>
        <translation>Parameter der Szene an die gemessene Reibung anpassen</translation>
    </message>
    <message>
        <source>Fit to measured friction…</source>
        <translation>An gemessene Reibung anpassen…</translation>
    </message>
    <message>
        <source>Theories</source>
        <translation>Theorien</translation>
    </message>
    <message>
        <source>Remove measured friction</source>
        <translation>Gemessene Reibung entfernen</translation>
    </message>
    <message>
        <source>The scene has no measured friction</source>
        <translation>Die Szene hat keine gemessene Reibung</translation>
    </message>
</context>
<context>
    <name>asperity::ContactCanvas</name>
    <message>
        <source>contact view</source>
        <translation>Kontaktansicht</translation>
    </message>
    <message>
        <source>The contact cannot be drawn here: %1</source>
        <translation>Der Kontakt lässt sich hier nicht zeichnen: %1</translation>
    </message>
    <message>
        <source>software</source>
        <translation>Software</translation>
    </message>
    <message>
        <source>Drag to the right to slide faster, to the left to slide slower.</source>
        <translation>Nach rechts ziehen: schneller gleiten; nach links: langsamer.</translation>
    </message>
    <message>
        <source>Drag down to press harder, up to press less.</source>
        <translation>Nach unten ziehen: stärker drücken; nach oben: schwächer.</translation>
    </message>
    <message>
        <source>Drag the body down into the elastomer or up; sideways moves a zoomed view.</source>
        <translation>Den Körper nach unten in das Elastomer ziehen oder nach oben; seitwärts bewegt sich eine vergrößerte Ansicht.</translation>
    </message>
    <message>
        <source>Drag down to press harder, up to press less; sideways moves a zoomed view.</source>
        <translation>Ziehen: nach unten stärker, nach oben schwächer drücken; seitwärts Ansicht bewegen.</translation>
    </message>
    <message>
        <source>Drag to the right for a larger velocity amplitude, to the left for a smaller one.</source>
        <translation>Ziehen nach rechts vergrößert die Geschwindigkeitsamplitude, nach links verkleinert sie.</translation>
    </message>
</context>
<context>
    <name>asperity::ContactWords</name>
    <message>
        <source>The contact in words</source>
        <translation>Der Kontakt in Worten</translation>
    </message>
    <message>
        <source>state of the contact</source>
        <translation>Zustand des Kontakts</translation>
    </message>
    <message>
        <source>&amp;Renew</source>
        <translation>&amp;Aktualisieren</translation>
    </message>
    <message>
        <source>The state at this moment (%1)</source>
        <translation>Der Zustand in diesem Augenblick (%1)</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation>&amp;Schließen</translation>
    </message>
</context>
<context>
    <name>asperity::CurveCommands</name>
    <message>
        <source>Pin curve</source>
        <translation>Kurve anheften</translation>
    </message>
    <message>
        <source>Keeps this curve to compare others with</source>
        <translation>Behält diese Kurve zum Vergleich mit anderen</translation>
    </message>
    <message>
        <source>Unpin</source>
        <translation>Lösen</translation>
    </message>
    <message>
        <source>Unpin all</source>
        <translation>Alle lösen</translation>
    </message>
    <message>
        <source>Dimensionless axes</source>
        <translation>Dimensionslose Achsen</translation>
    </message>
    <message>
        <source>v̄ of Eq. (13) and μ over the rms slope of the line</source>
        <translation>v̄ aus Gl. (13) und μ durch die RMS-Steigung der Linie</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Fit axes</source>
        <translation>Achsen einpassen</translation>
    </message>
    <message>
        <source>Save curve…</source>
        <translation>Kurve speichern…</translation>
    </message>
    <message>
        <source>Everything that is shown, as a picture or as a table</source>
        <translation>Alles Gezeigte als Bild oder als Tabelle</translation>
    </message>
    <message>
        <source>Copy curve picture</source>
        <translation>Kurvenbild kopieren</translation>
    </message>
    <message>
        <source>Save curve</source>
        <translation>Kurve speichern</translation>
    </message>
    <message>
        <source>Horizontal axis</source>
        <translation>Waagerechte Achse</translation>
    </message>
    <message>
        <source>Vertical axis</source>
        <translation>Senkrechte Achse</translation>
    </message>
    <message>
        <source>Family of curves</source>
        <translation>Kurvenschar</translation>
    </message>
    <message>
        <source>Linear horizontal axis</source>
        <translation>Waagerechte Achse linear</translation>
    </message>
    <message>
        <source>Linear vertical axis</source>
        <translation>Senkrechte Achse linear</translation>
    </message>
    <message>
        <source>Pins some curves, at as many values of another parameter</source>
        <translation>Heftet einige Kurven an, bei ebenso vielen Werten eines anderen Parameters</translation>
    </message>
    <message>
        <source>Read about it in the guide</source>
        <translation>Im Handbuch nachlesen</translation>
    </message>
    <message>
        <source>Opens the guide at what is under the pointer: a region, a curve, a law</source>
        <translation>Öffnet das Handbuch bei dem, was unter dem Zeiger ist: Bereich, Kurve, Gesetz</translation>
    </message>
    <message>
        <source>Curves in a family: %1</source>
        <translation>Kurven einer Schar: %1</translation>
    </message>
    <message>
        <source>No curve is pinned</source>
        <translation>Keine Kurve ist angeheftet</translation>
    </message>
    <message>
        <source>The curve&apos;s picture is on the clipboard</source>
        <translation>Das Bild der Kurve ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
</context>
<context>
    <name>asperity::CurveReadingText</name>
    <message>
        <source>region %1, %2</source>
        <translation>Bereich %1, %2</translation>
    </message>
    <message>
        <source>The status line has the standard error of the mean at this velocity; the tab Accuracy has the error of the whole curve, the root mean square over its velocities.</source>
        <translation>Die Statuszeile zeigt den Standardfehler des Mittels bei dieser Geschwindigkeit; der Reiter Genauigkeit zeigt den Fehler der ganzen Kurve, das quadratische Mittel über ihre Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>complete contact</source>
        <translation>Vollkontakt</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
</context>
<context>
    <name>asperity::DiagramFiles</name>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save picture or data</source>
        <translation>Bild oder Daten speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
</context>
<context>
    <name>asperity::DocumentCommands</name>
    <message>
        <source>Open scene…</source>
        <translation>Szene öffnen…</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save scene as…</source>
        <translation>Szene speichern unter…</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>%1 rückgängig machen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>%1 wiederherstellen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Revert to the opened scene</source>
        <translation>Zurück zur geöffneten Fassung</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Scenes, and what was made from one (*.json *.png *.svg *.pdf *.csv *.mp4 *.webm *.gif *.webp);;Scenes (*.json);;All files (*)</source>
        <translation>Szenen und was aus einer entstand (*.json *.png *.svg *.pdf *.csv *.mp4 *.webm *.gif *.webp);;Szenen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>It reads a file from another folder: %1</source>
        <translation>Sie liest eine Datei aus einem anderen Ordner: %1</translation>
    </message>
    <message>
        <source>It takes about %1 GB of memory.</source>
        <translation>Sie braucht etwa %1 GB Speicher.</translation>
    </message>
    <message>
        <source>Its curve takes about %1 minutes of processor time.</source>
        <translation>Die Kurve braucht etwa %1 Minuten Rechenzeit.</translation>
    </message>
    <message>
        <source>Asperity</source>
        <translation>Asperity</translation>
    </message>
    <message>
        <source>Open the scene in “%1”?</source>
        <translation>Die Szene in „%1“ öffnen?</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation>Szenen (*.json)</translation>
    </message>
    <message>
        <source>“%1” was changed. Save the changes?</source>
        <translation>„%1“ wurde geändert. Änderungen speichern?</translation>
    </message>
    <message>
        <source>They are saved in %1.</source>
        <translation>Sie werden in %1 gespeichert.</translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation>Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Liste leeren</translation>
    </message>
    <message>
        <source>No scene was opened or saved yet</source>
        <translation>Noch keine Szene geöffnet oder gespeichert</translation>
    </message>
</context>
<context>
    <name>asperity::ExportDialog</name>
    <message>
        <source>The program has written no file.</source>
        <translation>Das Programm hat keine Datei geschrieben.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>The picture is %1 pixels high, because its diagrams need that.</source>
        <translation>Das Bild ist %1 Pixel hoch, weil seine Diagramme das brauchen.</translation>
    </message>
    <message>
        <source>No preview.</source>
        <translation>Keine Vorschau.</translation>
    </message>
    <message>
        <source>File &amp;name</source>
        <translation>Datei&amp;name</translation>
    </message>
    <message>
        <source>file name</source>
        <translation>Dateiname</translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation>Du&amp;rchsuchen…</translation>
    </message>
    <message>
        <source>command line that writes the same file</source>
        <translation>Befehlszeile, die dieselbe Datei schreibt</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>&amp;Exportieren</translation>
    </message>
    <message>
        <source>The preview is being made…</source>
        <translation>Die Vorschau wird erstellt…</translation>
    </message>
    <message>
        <source>One picture of the film, which begins at time 0.</source>
        <translation>Ein Bild des Films, der zum Zeitpunkt 0 beginnt.</translation>
    </message>
    <message>
        <source>The curve of the preview is the mean of %1 lines, that of the file of %2.</source>
        <translation>Die Kurve der Vorschau ist das Mittel über %1 Linien, die der Datei über %2.</translation>
    </message>
    <message>
        <source>%1 exists already. Replace it?</source>
        <translation>%1 gibt es schon. Ersetzen?</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cance&amp;l</source>
        <translation>Ab&amp;brechen</translation>
    </message>
    <message>
        <source>Figure 2 of them.</source>
        <translation>Davon Abbildung 2.</translation>
    </message>
    <message>
        <source>The folder %1 has files already. Replace those of the same names?</source>
        <translation>Der Ordner %1 enthält schon Dateien. Gleichnamige ersetzen?</translation>
    </message>
    <message>
        <source>Command line</source>
        <translation>Befehlszeile</translation>
    </message>
</context>
<context>
    <name>asperity::ExportForm</name>
    <message>
        <source>%1: enter the name of the file in its own field.</source>
        <translation>%1: Der Dateiname gehört in sein eigenes Feld.</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>&amp;What</source>
        <translation>In&amp;halt</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>Forma&amp;t</translation>
    </message>
    <message>
        <source>St&amp;yle</source>
        <translation>St&amp;il</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keiner</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Farben</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>light</source>
        <translation>hell</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>print</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>paper, in light tints</source>
        <translation>Papier, in hellen Tönen</translation>
    </message>
    <message>
        <source>Trans&amp;parent background</source>
        <translation>&amp;Durchsichtiger Hintergrund</translation>
    </message>
    <message>
        <source>&amp;Duration (s)</source>
        <translation>Dauer (&amp;s)</translation>
    </message>
    <message>
        <source>Length of the film in seconds</source>
        <translation>Länge des Films in Sekunden</translation>
    </message>
    <message>
        <source>0.001 to 1000</source>
        <translation>0,001 bis 1000</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>the whole motion</source>
        <translation>die ganze Bewegung</translation>
    </message>
    <message>
        <source>periods of the line</source>
        <translation>Perioden der Linie</translation>
    </message>
    <message>
        <source>times slower</source>
        <translation>Mal langsamer</translation>
    </message>
    <message>
        <source>value of the speed</source>
        <translation>Wert des Tempos</translation>
    </message>
    <message>
        <source>Co&amp;lumns</source>
        <translation>Spa&amp;lten</translation>
    </message>
    <message>
        <source>Names of columns, separated by commas; empty: all</source>
        <translation>Namen von Spalten, durch Kommas getrennt; leer: alle</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Friction curve</source>
        <translation>Reibungskurve</translation>
    </message>
    <message>
        <source>Motion in time</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>Contact, point by point</source>
        <translation>Kontakt, Punkt für Punkt</translation>
    </message>
    <message>
        <source>List of contacts</source>
        <translation>Liste der Kontakte</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Kontakt</translation>
    </message>
    <message>
        <source>Contact and friction curve</source>
        <translation>Kontakt und Reibungskurve</translation>
    </message>
    <message>
        <source>Contact and motion in time</source>
        <translation>Kontakt und Zeitverlauf</translation>
    </message>
    <message>
        <source>PNG, pixels</source>
        <translation>PNG, Pixel</translation>
    </message>
    <message>
        <source>SVG, vectors</source>
        <translation>SVG, Vektoren</translation>
    </message>
    <message>
        <source>PDF, vectors</source>
        <translation>PDF, Vektoren</translation>
    </message>
    <message>
        <source>GIF, animated</source>
        <translation>GIF, bewegt</translation>
    </message>
    <message>
        <source>WebP, animated</source>
        <translation>WebP, bewegt</translation>
    </message>
    <message>
        <source>Fra&amp;mes per s</source>
        <translation>Bilder &amp;je s</translation>
    </message>
    <message>
        <source>&amp;Speed</source>
        <translation>Tem&amp;po</translation>
    </message>
    <message>
        <source>&amp;Other options</source>
        <translation>Weitere Opti&amp;onen</translation>
    </message>
    <message>
        <source>Any other options of the command, such as --font-size 9 --title none; asperity render --help lists them</source>
        <translation>Alle weiteren Optionen des Befehls, etwa --font-size 9 --title none; asperity render --help nennt sie</translation>
    </message>
    <message>
        <source>Figures of the paper</source>
        <translation>Abbildungen der Arbeit</translation>
    </message>
    <message>
        <source>A&amp;verage of lines</source>
        <translation>Ge&amp;mittelte Linien</translation>
    </message>
    <message>
        <source>Random lines over which each point is a mean; the paper has 200</source>
        <translation>Zufällige Linien, über die jeder Punkt gemittelt ist; in der Arbeit sind es 200</translation>
    </message>
    <message>
        <source>Figures 1 to 6</source>
        <translation>Abbildungen 1 bis 6</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Alle Abbildungen</translation>
    </message>
    <message>
        <source>Folder of PNG frames</source>
        <translation>Ordner mit PNG-Bildern</translation>
    </message>
    <message>
        <source>Folder: PNG, SVG, PDF, CSV</source>
        <translation>Ordner: PNG, SVG, PDF, CSV</translation>
    </message>
    <message>
        <source>Same p&amp;art of the line as in the window</source>
        <translation>Ausschnitt &amp;wie im Fenster</translation>
    </message>
    <message>
        <source>MP4 knows no transparency. WebM, GIF and WebP know it.</source>
        <translation>MP4 kennt keine Transparenz. WebM, GIF und WebP kennen sie.</translation>
    </message>
    <message>
        <source>Same p&amp;art of the line and moment as in the window</source>
        <translation>Ausschnitt und Zeitpunkt &amp;wie im Fenster</translation>
    </message>
    <message>
        <source>%1: “%2” is not a number above 0.</source>
        <translation>%1: „%2“ ist keine Zahl über 0.</translation>
    </message>
</context>
<context>
    <name>asperity::ExportSizeFields</name>
    <message>
        <source>Slide, 1280 × 720</source>
        <translation>Folie, 1280 × 720</translation>
    </message>
    <message>
        <source>Full HD, 1920 × 1080</source>
        <translation>Full HD, 1920 × 1080</translation>
    </message>
    <message>
        <source>4K, 3840 × 2160</source>
        <translation>4K, 3840 × 2160</translation>
    </message>
    <message>
        <source>Column of a journal, 86 × 62 mm</source>
        <translation>Spalte einer Zeitschrift, 86 × 62 mm</translation>
    </message>
    <message>
        <source>Page of a journal, 178 × 130 mm</source>
        <translation>Seite einer Zeitschrift, 178 × 130 mm</translation>
    </message>
    <message>
        <source>S&amp;ize</source>
        <translation>&amp;Größe</translation>
    </message>
    <message>
        <source>&amp;Resolution (dpi)</source>
        <translation>A&amp;uflösung (dpi)</translation>
    </message>
    <message>
        <source>Pixels per inch. More of them make texts and lines of a picture in pixels larger, and a picture on paper finer.</source>
        <translation>Pixel je Zoll. Mehr davon machen Texte und Linien eines Bildes in Pixeln größer und ein Bild auf Papier feiner.</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>unit of width and height</source>
        <translation>Einheit von Breite und Höhe</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>A picture on paper becomes higher where several panels need more room for their letters.</source>
        <translation>Ein Bild auf Papier wird höher, wenn mehrere Diagramme mehr Platz für ihre Beschriftung brauchen.</translation>
    </message>
    <message>
        <source>As in the window</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>Usual size</source>
        <translation>Übliche Größe</translation>
    </message>
    <message>
        <source>As the style says</source>
        <translation>Wie der Stil es sagt</translation>
    </message>
    <message>
        <source>Own size</source>
        <translation>Eigene Größe</translation>
    </message>
    <message>
        <source>Width, height and resolution are numbers above 0.</source>
        <translation>Breite, Höhe und Auflösung sind Zahlen über 0.</translation>
    </message>
    <message>
        <source>The picture has a %1 of %2 pixels; %3 to %4 are allowed.</source>
        <translation>Das Bild hat eine %1 von %2 Pixeln; erlaubt sind %3 bis %4.</translation>
    </message>
    <message>
        <source>The picture is too small for its diagrams; %1 × %2 %3 are enough.</source>
        <translation>Das Bild ist zu klein für seine Diagramme; %1 × %2 %3 genügen.</translation>
    </message>
    <message>
        <source>The picture is too small for its diagrams; make it higher or wider.</source>
        <translation>Das Bild ist zu klein für seine Diagramme; machen Sie es höher oder breiter.</translation>
    </message>
</context>
<context>
    <name>asperity::ExportPreview</name>
    <message>
        <source>preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>first lines of the table</source>
        <translation>erste Zeilen der Tabelle</translation>
    </message>
</context>
<context>
    <name>asperity::Exports</name>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save picture as shown…</source>
        <translation>Bild wie gezeigt speichern…</translation>
    </message>
    <message>
        <source>Copy as command line</source>
        <translation>Als Befehlszeile kopieren</translation>
    </message>
    <message>
        <source>Copy the curve&apos;s command line</source>
        <translation>Befehlszeile der Kurve kopieren</translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>Das Bild ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>There is no picture of the contact: this scene has not been computed.</source>
        <translation>Es gibt kein Bild des Kontakts: Diese Szene ist nicht berechnet.</translation>
    </message>
    <message>
        <source>On the clipboard: %1</source>
        <translation>In der Zwischenablage: %1</translation>
    </message>
    <message>
        <source>Export picture with options…</source>
        <translation>Bild mit Optionen exportieren…</translation>
    </message>
    <message>
        <source>Saves the contact, or the figure that is shown instead, in the size and the colours that it has in the window</source>
        <translation>Speichert den Kontakt oder die Abbildung, die statt seiner zu sehen ist, in der Größe und den Farben des Fensters</translation>
    </message>
    <message>
        <source>Opens a dialog with a preview: size, style, what stands below the contact, and the command line that makes the same picture</source>
        <translation>Öffnet einen Dialog mit Vorschau: Größe, Stil, was unter dem Kontakt steht, und die Befehlszeile, die dasselbe Bild macht</translation>
    </message>
    <message>
        <source>Export film…</source>
        <translation>Film exportieren…</translation>
    </message>
    <message>
        <source>Export table…</source>
        <translation>Tabelle exportieren…</translation>
    </message>
    <message>
        <source>Export figures of the paper…</source>
        <translation>Abbildungen der Arbeit exportieren…</translation>
    </message>
</context>
<context>
    <name>asperity::FigureQueue</name>
    <message>
        <source>Master curve</source>
        <translation>Masterkurve</translation>
    </message>
    <message>
        <source>Spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Figure %1</source>
        <translation>Abbildung %1</translation>
    </message>
</context>
<context>
    <name>asperity::FigureList</name>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>not computed</source>
        <translation>nicht berechnet</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>ready, 1 line</source>
        <translation>fertig, 1 Linie</translation>
    </message>
    <message>
        <source>ready, %1 lines</source>
        <translation>fertig, %1 Linien</translation>
    </message>
    <message>
        <source>figures of the paper</source>
        <translation>Abbildungen der Arbeit</translation>
    </message>
</context>
<context>
    <name>asperity::WindowPages</name>
    <message>
        <source>All figures</source>
        <translation>Alle Abbildungen</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>Gallery…</source>
        <translation>Galerie…</translation>
    </message>
</context>
<context>
    <name>asperity::FileDialogs</name>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Bilder (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>asperity::FitChoices</name>
    <message>
        <source>profile along each parameter</source>
        <translation>Profil entlang jedes Parameters</translation>
    </message>
    <message>
        <source>Measured friction</source>
        <translation>Gemessene Reibung</translation>
    </message>
    <message>
        <source>random lines</source>
        <translation>zufällige Linien</translation>
    </message>
    <message>
        <source>The least sum of squares with one parameter held: flat where the data leave it open</source>
        <translation>Die kleinste Summe der Quadrate bei einem festgehaltenen Parameter: flach, wo die Daten ihn offen lassen</translation>
    </message>
    <message>
        <source>parameters to vary</source>
        <translation>Parameter, die verändert werden</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>empty: as far as allowed, %1</source>
        <translation>leer: so weit wie erlaubt, %1</translation>
    </message>
    <message>
        <source>measured friction</source>
        <translation>gemessene Reibung</translation>
    </message>
    <message>
        <source>Parameters to fit</source>
        <translation>Anzupassende Parameter</translation>
    </message>
    <message>
        <source>Every trial uses the same random lines; their scatter is part of the errors</source>
        <translation>Jeder Versuch benutzt dieselben zufälligen Linien; deren Streuung ist Teil der Fehler</translation>
    </message>
</context>
<context>
    <name>asperity::FitPage</name>
    <message>
        <source>values and notes of the fit</source>
        <translation>Werte und Hinweise der Anpassung</translation>
    </message>
    <message>
        <source>Folder of the report</source>
        <translation>Ordner des Berichts</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>Bericht speichern</translation>
    </message>
    <message>
        <source>There is the report of another fit in this folder. Replace it?</source>
        <translation>In diesem Ordner steht der Bericht einer anderen Anpassung. Soll er ersetzt werden?</translation>
    </message>
    <message>
        <source>&amp;Save report…</source>
        <translation>Bericht &amp;speichern…</translation>
    </message>
    <message>
        <source>&amp;Use these values</source>
        <translation>Diese Werte &amp;übernehmen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Fit to measured friction</source>
        <translation>An gemessene Reibung anpassen</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Profiles</source>
        <translation>Profile</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>the fit as a diagram</source>
        <translation>die Anpassung als Diagramm</translation>
    </message>
    <message>
        <source>progress of the fit</source>
        <translation>Fortschritt der Anpassung</translation>
    </message>
    <message>
        <source>The fit was stopped</source>
        <translation>Die Anpassung wurde angehalten</translation>
    </message>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message>
        <source>evaluation %1, χ² = %2</source>
        <translation>Auswertung %1, χ² = %2</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>&amp;Fit again</source>
        <translation>Noch einmal &amp;anpassen</translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation>&amp;Anpassen</translation>
    </message>
    <message>
        <source>Saved %1 files in %2</source>
        <translation>%1 Dateien in %2 gespeichert</translation>
    </message>
    <message>
        <source>not determined</source>
        <translation>nicht bestimmt</translation>
    </message>
    <message>
        <source>at its limit</source>
        <translation>an seiner Grenze</translation>
    </message>
    <message>
        <source>determined</source>
        <translation>bestimmt</translation>
    </message>
    <message>
        <source>best determined together: %1 (± %2 %)</source>
        <translation>gemeinsam am besten bestimmt: %1 (± %2 %)</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>best value</source>
        <translation>bester Wert</translation>
    </message>
    <message>
        <source>± standard error</source>
        <translation>± Standardfehler</translation>
    </message>
    <message>
        <source>correlation: %1</source>
        <translation>Korrelation: %1</translation>
    </message>
    <message>
        <source>χ² = %1 for %2, %3 evaluations</source>
        <translation>χ² = %1 bei %2, %3 Auswertungen</translation>
    </message>
    <message>
        <source>the points have no errors; they scatter by %1 % about the fit</source>
        <translation>die Punkte haben keine Fehler; sie streuen um %1 % um die Anpassung</translation>
    </message>
    <message>
        <source>Tick the parameters to fit; type limits, which are optional, into “from” and “to”. Every trial uses the same random lines, and the weighted sum of the squared residuals is minimized. The best values appear here, and below them the curve with the points.</source>
        <translation>Die anzupassenden Parameter ankreuzen; Grenzen, die freigestellt sind, in „von“ und „bis“ eintragen. Jeder Versuch benutzt dieselben zufälligen Linien, und die gewichtete Summe der Fehlerquadrate wird minimiert. Hier erscheinen die besten Werte, darunter die Kurve mit den Punkten.</translation>
    </message>
    <message>
        <source>curve misses the points</source>
        <translation>Kurve verfehlt die Punkte</translation>
    </message>
</context>
<context>
    <name>asperity::FrameDisplay</name>
    <message>
        <source>This scene is being computed</source>
        <translation>Diese Szene wird noch berechnet</translation>
    </message>
    <message>
        <source>This scene cannot be computed</source>
        <translation>Diese Szene lässt sich nicht berechnen</translation>
    </message>
    <message>
        <source>This is the previous scene; the changed one is being computed</source>
        <translation>Dies ist die vorige Szene; die geänderte wird noch berechnet</translation>
    </message>
    <message>
        <source>This is the previous scene; the changed one cannot be computed</source>
        <translation>Dies ist die vorige Szene; die geänderte lässt sich nicht berechnen</translation>
    </message>
</context>
<context>
    <name>asperity::FiguresPage</name>
    <message>
        <source>Figures of Li et al. (2013), computed here and now</source>
        <translation>Abbildungen von Li et al. (2013), hier und jetzt berechnet</translation>
    </message>
    <message>
        <source>&amp;Realizations</source>
        <translation>&amp;Realisierungen</translation>
    </message>
    <message>
        <source>realizations to average over</source>
        <translation>Realisierungen, über die gemittelt wird</translation>
    </message>
    <message>
        <source>&amp;Quick</source>
        <translation>Sch&amp;nell</translation>
    </message>
    <message>
        <source>%1 realizations</source>
        <translation>%1 Realisierungen</translation>
    </message>
    <message>
        <source>Pap&amp;er</source>
        <translation>Wie in der Arbei&amp;t</translation>
    </message>
    <message>
        <source>%1 realizations, as in the paper</source>
        <translation>%1 Realisierungen wie in der Arbeit</translation>
    </message>
    <message>
        <source>Compute &amp;all</source>
        <translation>&amp;Alle</translation>
    </message>
    <message>
        <source>All figures, one after another</source>
        <translation>Alle Abbildungen nacheinander</translation>
    </message>
    <message>
        <source>&amp;Compute</source>
        <translation>&amp;Berechnen</translation>
    </message>
    <message>
        <source>Computes this figure from new lines (Enter in the list)</source>
        <translation>Diese Abbildung aus neu erzeugten Linien (Eingabetaste in der Liste)</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>Stops this computation and all that wait</source>
        <translation>Beendet die laufende und alle wartenden Berechnungen</translation>
    </message>
    <message>
        <source>&amp;Open as scene</source>
        <translation>Als &amp;Szene öffnen</translation>
    </message>
    <message>
        <source>This figure&apos;s parameters in the window, to play with</source>
        <translation>Die Parameter dieser Abbildung im Fenster, zum Ausprobieren</translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation>B&amp;ild speichern…</translation>
    </message>
    <message>
        <source>PNG, SVG or PDF</source>
        <translation>PNG, SVG oder PDF</translation>
    </message>
    <message>
        <source>Save &amp;data…</source>
        <translation>&amp;Daten speichern…</translation>
    </message>
    <message>
        <source>The table as CSV, or the claims as JSON</source>
        <translation>Die Tabelle als CSV oder die Aussagen als JSON</translation>
    </message>
    <message>
        <source>progress of the computation</source>
        <translation>Fortschritt der Berechnung</translation>
    </message>
    <message>
        <source>%1 is not computed yet.</source>
        <translation>%1 ist noch nicht berechnet.</translation>
    </message>
    <message>
        <source>%1 appears here once it is computed.</source>
        <translation>%1 erscheint hier, sobald die Berechnung fertig ist.</translation>
    </message>
    <message>
        <source>&amp;Compute again</source>
        <translation>Neu &amp;berechnen</translation>
    </message>
    <message>
        <source>Save data</source>
        <translation>Daten speichern</translation>
    </message>
    <message>
        <source>Table (*.csv);;Claims (*.json)</source>
        <translation>Tabelle (*.csv);;Aussagen (*.json)</translation>
    </message>
    <message>
        <source>The picture is on the clipboard</source>
        <translation>Das Bild ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>Saving %1…</source>
        <translation>%1 wird gespeichert…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>asperity::HandoutSaver</name>
    <message>
        <source>Handout</source>
        <translation>Arbeitsblatt</translation>
    </message>
    <message>
        <source>A handout for students has the questions; one for teachers has the answers and the notes, too.</source>
        <translation>Ein Arbeitsblatt für Lernende hat die Fragen; eines für Lehrende hat auch die Antworten und die Hinweise.</translation>
    </message>
    <message>
        <source>For &amp;students</source>
        <translation>Für &amp;Lernende</translation>
    </message>
    <message>
        <source>For &amp;teachers</source>
        <translation>Für L&amp;ehrende</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>Save handout</source>
        <translation>Arbeitsblatt speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf);;Web page (*.html)</source>
        <translation>PDF (*.pdf);;Webseite (*.html)</translation>
    </message>
    <message>
        <source>The program draws the pictures and computes the answers…</source>
        <translation>Das Programm zeichnet die Bilder und berechnet die Antworten…</translation>
    </message>
</context>
<context>
    <name>asperity::HelpCommands</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Guide</source>
        <translation>Handbuch (englisch)</translation>
    </message>
    <message>
        <source>About Asperity</source>
        <translation>Über Asperity</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Asperity %1&lt;/h3&gt;</source>
        <translation>&lt;h3&gt;Asperity %1&lt;/h3&gt;</translation>
    </message>
    <message>
        <source>Shows how a viscoelastic elastomer slides over a randomly rough rigid line, after Li et al., &lt;i&gt;Friction between a viscoelastic body and a rigid surface with random self-affine roughness&lt;/i&gt;, Physical Review Letters 111, 034301 (2013).&lt;br&gt;&lt;br&gt;The elements of the elastomer are independent of each other: long-range elastic coupling is not in the model.&lt;br&gt;&lt;br&gt;Free software, GPL-3.0-or-later.</source>
        <translation>Zeigt, wie ein viskoelastisches Elastomer über eine zufällig raue starre Linie gleitet, nach Li et al., &lt;i&gt;Friction between a viscoelastic body and a rigid surface with random self-affine roughness&lt;/i&gt;, Physical Review Letters 111, 034301 (2013).&lt;br&gt;&lt;br&gt;Die Elemente des Elastomers sind voneinander unabhängig: Eine langreichweitige elastische Kopplung ist nicht im Modell.&lt;br&gt;&lt;br&gt;Freie Software, GPL-3.0-or-later.</translation>
    </message>
    <message>
        <source>The guide is not part of this build. Its text is in resources/guide.</source>
        <translation>Das Handbuch ist nicht Teil dieses Programms. Sein Text steht in resources/guide.</translation>
    </message>
    <message>
        <source>No browser opens the guide; it is the file %1.</source>
        <translation>Kein Browser öffnet das Handbuch; es ist die Datei %1.</translation>
    </message>
</context>
<context>
    <name>asperity::ImportCommands</name>
    <message>
        <source>Open surface…</source>
        <translation>Oberfläche öffnen…</translation>
    </message>
    <message>
        <source>Open material…</source>
        <translation>Material öffnen…</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Oberfläche öffnen</translation>
    </message>
    <message>
        <source>Measured surfaces (%1);;All files (*)</source>
        <translation>Gemessene Oberflächen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Open material</source>
        <translation>Material öffnen</translation>
    </message>
    <message>
        <source>Materials and measured moduli (*.json *.csv *.txt *.dat *.inp);;All files (*)</source>
        <translation>Materialien und gemessene Moduln (*.json *.csv *.txt *.dat *.inp);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add measured friction…</source>
        <translation>Gemessene Reibung hinzufügen…</translation>
    </message>
    <message>
        <source>Add measured friction</source>
        <translation>Gemessene Reibung hinzufügen</translation>
    </message>
    <message>
        <source>Tables of velocity and friction (*.csv *.txt *.dat *.tsv);;All files (*)</source>
        <translation>Tabellen von Geschwindigkeit und Reibung (*.csv *.txt *.dat *.tsv);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>asperity::ImportPage</name>
    <message>
        <source>reading…</source>
        <translation>wird gelesen…</translation>
    </message>
    <message>
        <source>Nothing of this file can be shown.</source>
        <translation>Von dieser Datei lässt sich nichts zeigen.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>progress of reading</source>
        <translation>Fortschritt des Lesens</translation>
    </message>
    <message>
        <source>Read the file again</source>
        <translation>Die Datei noch einmal lesen</translation>
    </message>
    <message>
        <source>Stop reading</source>
        <translation>Lesen anhalten</translation>
    </message>
    <message>
        <source>Reading was stopped</source>
        <translation>Das Lesen wurde angehalten</translation>
    </message>
    <message>
        <source>the first lines of the file</source>
        <translation>die ersten Zeilen der Datei</translation>
    </message>
</context>
<context>
    <name>asperity::InfluencePage</name>
    <message>
        <source>The influences are being computed… %1 %</source>
        <translation>Die Einflüsse werden berechnet… %1 %</translation>
    </message>
    <message>
        <source>what friction depends on</source>
        <translation>wovon die Reibung abhängt</translation>
    </message>
    <message>
        <source>Which parameter matters</source>
        <translation>Welcher Parameter zählt</translation>
    </message>
    <message>
        <source>Which wavelengths matter</source>
        <translation>Welche Wellenlängen zählen</translation>
    </message>
    <message>
        <source>friction without the waves below a cut-off</source>
        <translation>Reibung ohne die Wellen unter einer Grenze</translation>
    </message>
    <message>
        <source>% of friction for 1 % of each parameter</source>
        <translation>Änderung der Reibung in %, je 1 % des Parameters</translation>
    </message>
</context>
<context>
    <name>asperity::LastSessionText</name>
    <message>
        <source>The scene of last time cannot be shown: %1</source>
        <translation>Die Szene vom letzten Mal kann nicht gezeigt werden: %1</translation>
    </message>
</context>
<context>
    <name>asperity::LessonValidation</name>
    <message>
        <source>Choice %1: needs a number in From or To, as the others have</source>
        <translation>Antwort %1: braucht wie die anderen eine Zahl in „Von“ oder „Bis“</translation>
    </message>
    <message>
        <source>Choice %1: From has to be less than To</source>
        <translation>Antwort %1: „Von“ muss kleiner als „Bis“ sein</translation>
    </message>
    <message>
        <source>Choice %1: its range overlaps that of choice %2, so that one answer would make both right</source>
        <translation>Antwort %1: ihr Bereich überlappt den von Antwort %2, sodass ein Ergebnis beide richtig machen würde</translation>
    </message>
    <message>
        <source>%1: %2 is not above 0 and up to %3</source>
        <translation>%1: %2 liegt nicht über 0 und höchstens bei %3</translation>
    </message>
    <message>
        <source>the step needs a text</source>
        <translation>der Schritt braucht einen Text</translation>
    </message>
    <message>
        <source>the question needs a text</source>
        <translation>die Frage braucht einen Text</translation>
    </message>
    <message>
        <source>a point needs the tab “Friction curve” in front, on which it lies</source>
        <translation>ein Punkt braucht vorn den Reiter „Reibungskurve“, auf dem er liegt</translation>
    </message>
    <message>
        <source>Tolerance in %</source>
        <translation>Toleranz in %</translation>
    </message>
    <message>
        <source>Tolerance of the place in %</source>
        <translation>Toleranz der Stelle in %</translation>
    </message>
    <message>
        <source>Choices: write at least two</source>
        <translation>Antworten: Schreiben Sie mindestens zwei</translation>
    </message>
    <message>
        <source>Choices: tick the right one, or write into From and To for which computed answers each is right</source>
        <translation>Antworten: Haken Sie die richtige an, oder schreiben Sie in „Von“ und „Bis“, für welche berechneten Antworten jede richtig ist</translation>
    </message>
    <message>
        <source>The lesson needs a title</source>
        <translation>Die Lektion braucht einen Titel</translation>
    </message>
    <message>
        <source>A lesson needs at least one step</source>
        <translation>Eine Lektion braucht mindestens einen Schritt</translation>
    </message>
    <message>
        <source>Step %1: %2</source>
        <translation>Schritt %1: %2</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>notes for teachers</source>
        <translation>Hinweise für Lehrende</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>changed with the answer</source>
        <translation>mit der Antwort geändert</translation>
    </message>
    <message>
        <source>tab in front</source>
        <translation>Reiter vorn</translation>
    </message>
    <message>
        <source>quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>controls</source>
        <translation>Regler</translation>
    </message>
    <message>
        <source>prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>choices</source>
        <translation>Antworten zur Auswahl</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>computed answer</source>
        <translation>berechnete Antwort</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>place on the axis</source>
        <translation>Stelle auf der Achse</translation>
    </message>
    <message>
        <source>if right</source>
        <translation>wenn richtig</translation>
    </message>
    <message>
        <source>if wrong</source>
        <translation>wenn falsch</translation>
    </message>
    <message>
        <source>said with the answer</source>
        <translation>mit der Antwort gesagt</translation>
    </message>
    <message>
        <source>values of the texts</source>
        <translation>Werte der Texte</translation>
    </message>
    <message>
        <source>step %1</source>
        <translation>Schritt %1</translation>
    </message>
    <message>
        <source>choice %1</source>
        <translation>Antwort %1</translation>
    </message>
    <message>
        <source>The program computes an answer that no choice may cover…</source>
        <translation>Das Programm berechnet eine Ergebniszahl, die vielleicht in keinem der Bereiche liegt…</translation>
    </message>
    <message>
        <source>Step %1, computed answer: %2</source>
        <translation>Schritt %1, berechnete Antwort: %2</translation>
    </message>
    <message>
        <source>The program finds %1.</source>
        <translation>Das Programm findet %1.</translation>
    </message>
    <message>
        <source>The program finds no answer.</source>
        <translation>Das Programm findet keine Antwort.</translation>
    </message>
    <message>
        <source>The program computes the answer…</source>
        <translation>Das Programm berechnet die Antwort…</translation>
    </message>
    <message>
        <source>The program computes the answer when the lesson is complete.</source>
        <translation>Das Programm berechnet die Antwort, wenn die Lektion vollständig ist.</translation>
    </message>
    <message>
        <source>Computed answers are means over the scene&apos;s %1 lines; the picture shows one.</source>
        <translation>Berechnete Antworten sind Mittelwerte über die %1 Linien der Szene; das Bild zeigt eine.</translation>
    </message>
    <message>
        <source>The picture stays as it is when the answer is shown: “Changed with the answer” does not have the changes of the computed answer.</source>
        <translation>Das Bild bleibt, wie es ist, wenn die Antwort gezeigt wird: „Mit der Antwort geändert“ hat die Änderungen der berechneten Antwort nicht.</translation>
    </message>
    <message>
        <source>The curve, which is in sight, may show this answer.</source>
        <translation>Die Kurve ist zu sehen und verrät vielleicht diese Antwort.</translation>
    </message>
</context>
<context>
    <name>asperity::LessonEditor</name>
    <message>
        <source>Lesson editor</source>
        <translation>Lektionen schreiben</translation>
    </message>
    <message>
        <source>language of the texts</source>
        <translation>Sprache der Texte</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>&amp;Add step from what is shown</source>
        <translation>Schritt aus dem &amp;Gezeigten hinzufügen</translation>
    </message>
    <message>
        <source>The scene, the tab and the quantity of the chart, as they are now</source>
        <translation>Szene, Reiter und Größe des Diagramms, wie sie jetzt sind</translation>
    </message>
    <message>
        <source>&amp;Up</source>
        <translation>&amp;Hinauf</translation>
    </message>
    <message>
        <source>&amp;Down</source>
        <translation>Hi&amp;nab</translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation>&amp;Entfernen</translation>
    </message>
    <message>
        <source>&amp;Try this step</source>
        <translation>Schritt &amp;probieren</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Save lesson</source>
        <translation>Lektion speichern</translation>
    </message>
    <message>
        <source>Lessons (*.json)</source>
        <translation>Lektionen (*.json)</translation>
    </message>
    <message>
        <source>The lesson</source>
        <translation>Die Lektion</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>(no title)</source>
        <translation>(ohne Titel)</translation>
    </message>
    <message>
        <source>What is to be seen here?</source>
        <translation>Was ist hier zu sehen?</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>Ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Open lesson</source>
        <translation>Lektion öffnen</translation>
    </message>
    <message>
        <source>Lessons (*.json);;All files (*)</source>
        <translation>Lektionen (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>&amp;Handout…</source>
        <translation>&amp;Arbeitsblatt…</translation>
    </message>
    <message>
        <source>Pages to print, as PDF or as a web page</source>
        <translation>Seiten zum Drucken, als PDF oder als Webseite</translation>
    </message>
    <message>
        <source>The lesson was changed and not saved.</source>
        <translation>Die Lektion wurde geändert und nicht gespeichert.</translation>
    </message>
    <message>
        <source>U&amp;ndo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>R&amp;edo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>%1, as step %2 leaves it</source>
        <translation>%1, wie Schritt %2 sie hinterlässt</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Also saves a lesson that is not complete yet (Ctrl+S)</source>
        <translation>Speichert auch eine Lektion, die noch nicht fertig ist (Strg+S)</translation>
    </message>
    <message>
        <source>Sa&amp;ve as…</source>
        <translation>Speichern &amp;unter…</translation>
    </message>
    <message>
        <source>%1 (%2 missing)</source>
        <translation>%1 (Lücken: %2)</translation>
    </message>
    <message>
        <source>Not translated: %1. A question that lacks a translation stands in the other language as a whole.</source>
        <translation>Nicht übersetzt: %1. Eine Frage, der eine Übersetzung fehlt, steht als Ganzes in der anderen Sprache.</translation>
    </message>
    <message>
        <source>The main window shows the gallery. Open a scene in it, then add the step.</source>
        <translation>Das Hauptfenster zeigt die Galerie. Öffnen Sie darin eine Szene, und fügen Sie dann den Schritt hinzu.</translation>
    </message>
    <message>
        <source>Saved %1 as a draft. Before it can be played: %2</source>
        <translation>%1 als Entwurf gespeichert. Bevor er gespielt werden kann: %2</translation>
    </message>
</context>
<context>
    <name>asperity::LessonHeadPage</name>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>Minuten</translation>
    </message>
    <message>
        <source>Notes for teachers</source>
        <translation>Für Lehrende</translation>
    </message>
</context>
<context>
    <name>asperity::LessonList</name>
    <message>
        <source>about the lesson</source>
        <translation>über die Lektion</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Beginnen</translation>
    </message>
    <message>
        <source>Show the notes for &amp;teachers, with answers</source>
        <translation>Hinweise für &amp;Lehrende zeigen, mit Antworten</translation>
    </message>
    <message>
        <source>&amp;Open lesson or results…</source>
        <translation>Lektion oder Ergebnisse ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>&amp;Handout…</source>
        <translation>&amp;Arbeitsblatt…</translation>
    </message>
    <message>
        <source>&amp;Edit a copy…</source>
        <translation>&amp;Kopie bearbeiten…</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>%1 minutes, %2 steps</source>
        <translation>%1 Minuten, %2 Schritte</translation>
    </message>
    <message>
        <source>For teachers</source>
        <translation>Für Lehrende</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>They are being computed…</source>
        <translation>Sie werden berechnet …</translation>
    </message>
    <message>
        <source>They could not be computed.</source>
        <translation>Sie konnten nicht berechnet werden.</translation>
    </message>
    <message>
        <source>Open a lesson or the results of students</source>
        <translation>Eine Lektion oder Ergebnisse öffnen</translation>
    </message>
    <message>
        <source>Lessons and results (*.json);;All files (*)</source>
        <translation>Lektionen und Ergebnisse (*.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Several files of results make a table of the class</source>
        <translation>Mehrere Dateien mit Ergebnissen ergeben eine Tabelle der Klasse</translation>
    </message>
</context>
<context>
    <name>asperity::LessonPane</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Show me</source>
        <translation>Zeig es mir</translation>
    </message>
    <message>
        <source>Shows the answer without a guess</source>
        <translation>Zeigt die Antwort, ohne dass du rätst</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>your answer</source>
        <translation>deine Antwort</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>A number is needed, such as 0.5.</source>
        <translation>Hier muss eine Zahl stehen, etwa 0,5.</translation>
    </message>
    <message>
        <source>A number is needed, in %1.</source>
        <translation>Hier muss eine Zahl stehen, in %1.</translation>
    </message>
    <message>
        <source>The program computes the answer…</source>
        <translation>Das Programm berechnet die Antwort…</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Finish</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Your number is read as %1.</source>
        <translation>Deine Zahl wird als %1 gelesen.</translation>
    </message>
</context>
<context>
    <name>asperity::LessonDock</name>
    <message>
        <source>Lesson</source>
        <translation>Lektion</translation>
    </message>
    <message>
        <source>Keeps your answers in a file of your choice</source>
        <translation>Bewahrt deine Antworten in einer Datei deiner Wahl auf</translation>
    </message>
    <message>
        <source>Save results…</source>
        <translation>Ergebnisse speichern…</translation>
    </message>
    <message>
        <source>Ends the lesson; your own scene comes back</source>
        <translation>Beendet die Lektion; deine eigene Szene kommt zurück</translation>
    </message>
    <message>
        <source>end the lesson</source>
        <translation>Lektion beenden</translation>
    </message>
    <message>
        <source>Lesson: %1</source>
        <translation>Lektion: %1</translation>
    </message>
    <message>
        <source>Steps of the lesson</source>
        <translation>Schritte der Lektion</translation>
    </message>
</context>
<context>
    <name>asperity::LessonPlayer</name>
    <message>
        <source>Lesson: back</source>
        <translation>Lektion: zurück</translation>
    </message>
    <message>
        <source>Lesson: next</source>
        <translation>Lektion: weiter</translation>
    </message>
    <message>
        <source>End the lesson</source>
        <translation>Lektion beenden</translation>
    </message>
    <message>
        <source>You were right in %1 of %2 predictions.</source>
        <translation>Du hattest bei %1 von %2 Vorhersagen recht.</translation>
    </message>
    <message>
        <source>You were right in %1 of %2 predictions; 1 was shown to you.</source>
        <translation>Du hattest bei %1 von %2 Vorhersagen recht; eine hast du dir zeigen lassen.</translation>
    </message>
    <message>
        <source>You were right in %1 of %2 predictions; %3 were shown to you.</source>
        <translation>Du hattest bei %1 von %2 Vorhersagen recht; %3 hast du dir zeigen lassen.</translation>
    </message>
    <message>
        <source>“%1” is locked in this step.</source>
        <translation>„%1“ ist in diesem Schritt gesperrt.</translation>
    </message>
    <message>
        <source>First make your guess; then you can try it.</source>
        <translation>Erst rate; dann kannst du es probieren.</translation>
    </message>
</context>
<context>
    <name>asperity::LessonResultsPage</name>
    <message>
        <source>%1 right, %2 wrong, %3 shown</source>
        <translation>%1 richtig, %2 falsch, %3 gezeigt</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Results of a lesson</source>
        <translation>Ergebnisse einer Lektion</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Results of a class</source>
        <translation>Ergebnisse einer Klasse</translation>
    </message>
    <message>
        <source>Files without results</source>
        <translation>Dateien ohne Ergebnisse</translation>
    </message>
    <message>
        <source>&amp;Go on with these answers</source>
        <translation>Mit diesen Antworten &amp;weitermachen</translation>
    </message>
    <message>
        <source>&amp;Save table…</source>
        <translation>&amp;Tabelle speichern…</translation>
    </message>
    <message>
        <source>Save the table of a class</source>
        <translation>Tabelle einer Klasse speichern</translation>
    </message>
    <message>
        <source>class.csv</source>
        <translation>Klasse.csv</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
</context>
<context>
    <name>asperity::LessonStepPage</name>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>Vertical axis</source>
        <translation>Senkrechte Achse</translation>
    </message>
    <message>
        <source>Free controls</source>
        <translation>Freie Regler</translation>
    </message>
    <message>
        <source>%1 controls</source>
        <translation>%1 Regler</translation>
    </message>
    <message>
        <source>free controls: %1</source>
        <translation>freie Regler: %1</translation>
    </message>
    <message>
        <source>Changed in the scene</source>
        <translation>In der Szene geändert</translation>
    </message>
    <message>
        <source>What this step changes in the scene that the step before leaves</source>
        <translation>Was dieser Schritt an der Szene ändert, die der Schritt davor hinterlässt</translation>
    </message>
    <message>
        <source>Tab in front</source>
        <translation>Reiter vorn</translation>
    </message>
    <message>
        <source>Friction curve</source>
        <translation>Reibungskurve</translation>
    </message>
    <message>
        <source>Motion in time</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Influences</source>
        <translation>Einflüsse</translation>
    </message>
    <message>
        <source>What students may change once they have answered</source>
        <translation>Was Lernende ändern dürfen, sobald sie geantwortet haben</translation>
    </message>
    <message>
        <source>Other controls</source>
        <translation>Andere Regler</translation>
    </message>
    <message>
        <source>hidden</source>
        <translation>verborgen</translation>
    </message>
    <message>
        <source>in sight, but locked</source>
        <translation>zu sehen, aber gesperrt</translation>
    </message>
    <message>
        <source>free, too</source>
        <translation>auch frei</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>Auswählen…</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Take the scene that is shown</source>
        <translation>Gezeigte Szene übernehmen</translation>
    </message>
    <message>
        <source>The step begins with the scene of the main window, as it is now</source>
        <translation>Der Schritt beginnt mit der Szene des Hauptfensters, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>all except: %1</source>
        <translation>alle außer: %1</translation>
    </message>
    <message>
        <source>*italic*, **bold**; an empty line begins a paragraph; a line that begins with “- ” is an item</source>
        <translation>*kursiv*, **fett**; eine leere Zeile beginnt einen Absatz; eine Zeile, die mit „- “ beginnt, ist ein Punkt einer Liste</translation>
    </message>
</context>
<context>
    <name>asperity::LessonValueFields</name>
    <message>
        <source>Computed answer</source>
        <translation>Berechnete Antwort</translation>
    </message>
    <message>
        <source>from</source>
        <translation>von</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>standard error of μ</source>
        <translation>Standardfehler von μ</translation>
    </message>
    <message>
        <source>μ by Eq. (11)</source>
        <translation>μ nach Gl. (11)</translation>
    </message>
    <message>
        <source>dimensionless velocity</source>
        <translation>dimensionslose Geschwindigkeit</translation>
    </message>
    <message>
        <source>dimensionless force</source>
        <translation>dimensionslose Kraft</translation>
    </message>
    <message>
        <source>μ of the local friction</source>
        <translation>μ der lokalen Reibung</translation>
    </message>
    <message>
        <source>μ with the local friction</source>
        <translation>μ mit der lokalen Reibung</translation>
    </message>
    <message>
        <source>mean of the ratios of force to load</source>
        <translation>Mittel der Verhältnisse von Kraft zu Last</translation>
    </message>
    <message>
        <source>ratio of the mean force to the mean load</source>
        <translation>Verhältnis der mittleren Kraft zur mittleren Last</translation>
    </message>
    <message>
        <source>share of its load on an element that just touches</source>
        <translation>Lastanteil eines Elements, das gerade berührt</translation>
    </message>
    <message>
        <source>whether it rests on frequencies that were not measured</source>
        <translation>ob es auf nicht gemessenen Frequenzen beruht</translation>
    </message>
    <message>
        <source>normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>nominal pressure</source>
        <translation>nomineller Druck</translation>
    </message>
    <message>
        <source>number of contacts</source>
        <translation>Anzahl der Kontakte</translation>
    </message>
    <message>
        <source>the value after the changes below</source>
        <translation>der Wert nach den Änderungen unten</translation>
    </message>
    <message>
        <source>how many times as large as in this step</source>
        <translation>wievielmal so groß wie in diesem Schritt</translation>
    </message>
    <message>
        <source>where on the axis it is largest</source>
        <translation>wo auf der Achse er am größten ist</translation>
    </message>
    <message>
        <source>the power of a parameter with which it grows</source>
        <translation>mit welcher Potenz eines Parameters er wächst</translation>
    </message>
    <message>
        <source>of the quantity</source>
        <translation>der Größe</translation>
    </message>
    <message>
        <source>of the parameter</source>
        <translation>des Parameters</translation>
    </message>
    <message>
        <source>Two values of the parameter, both above 0, between which the slope of the curve in logarithms is computed</source>
        <translation>Zwei Werte des Parameters, beide über 0, zwischen denen die Steigung der Kurve in Logarithmen berechnet wird</translation>
    </message>
    <message>
        <source>after the changes</source>
        <translation>nach den Änderungen</translation>
    </message>
</context>
<context>
    <name>asperity::Lessons</name>
    <message>
        <source>Lessons…</source>
        <translation>Lektionen…</translation>
    </message>
    <message>
        <source>Lesson editor…</source>
        <translation>Lektion schreiben…</translation>
    </message>
    <message>
        <source>Your answers from before are here.</source>
        <translation>Deine Antworten von vorhin sind hier.</translation>
    </message>
    <message>
        <source>Asperity</source>
        <translation>Asperity</translation>
    </message>
    <message>
        <source>Save your answers?</source>
        <translation>Deine Antworten speichern?</translation>
    </message>
    <message>
        <source>They go into a file of your choice. Otherwise they are lost.</source>
        <translation>Sie kommen in eine Datei deiner Wahl. Sonst gehen sie verloren.</translation>
    </message>
    <message>
        <source>File of your results</source>
        <translation>Datei deiner Ergebnisse</translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation>Ergebnisse (*.json)</translation>
    </message>
    <message>
        <source>Your answers are kept in %1.</source>
        <translation>Deine Antworten werden in %1 aufbewahrt.</translation>
    </message>
    <message>
        <source>This lesson cannot be played yet; Help &gt; Lesson editor &gt; Open completes it. %1</source>
        <translation>Diese Lektion kann noch nicht gespielt werden; Hilfe &gt; Lektion schreiben &gt; Öffnen vervollständigt sie. %1</translation>
    </message>
    <message>
        <source>%1, results %2.json</source>
        <translation>%1, Ergebnisse %2.json</translation>
    </message>
    <message>
        <source>(no title)</source>
        <translation>(ohne Titel)</translation>
    </message>
    <message>
        <source>The lesson “%1” was changed in the editor and not saved before the program ended. Go on with it?</source>
        <translation>Die Lektion „%1“ wurde im Editor geändert und nicht gespeichert, bevor das Programm endete. Damit weitermachen?</translation>
    </message>
    <message>
        <source>What you discard is lost.</source>
        <translation>Was du verwirfst, geht verloren.</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>&amp;Weitermachen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>&amp;Verwerfen</translation>
    </message>
    <message>
        <source>This lesson was begun before (%1), and its answers are in no file. Go on with these answers?</source>
        <translation>Diese Lektion wurde schon begonnen (%1), und ihre Antworten sind in keiner Datei. Mit diesen Antworten weitermachen?</translation>
    </message>
    <message>
        <source>Your answers to this lesson are in %1. Go on with these answers?</source>
        <translation>Deine Antworten zu dieser Lektion sind in %1. Mit diesen Antworten weitermachen?</translation>
    </message>
    <message>
        <source>The file stays if you begin anew.</source>
        <translation>Die Datei bleibt, wenn du neu beginnst.</translation>
    </message>
    <message>
        <source>&amp;Begin anew</source>
        <translation>&amp;Neu beginnen</translation>
    </message>
    <message>
        <source>Table of a class…</source>
        <translation>Tabelle einer Klasse…</translation>
    </message>
    <message>
        <source>Results of a class</source>
        <translation>Ergebnisse einer Klasse</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Ergebnisse (*.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>asperity::ListBox</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 theories</source>
        <translation>%1 Theorien</translation>
    </message>
    <message>
        <source>%1 tables</source>
        <translation>%1 Tabellen</translation>
    </message>
    <message>
        <source>Add a table…</source>
        <translation>Tabelle hinzufügen…</translation>
    </message>
</context>
<context>
    <name>asperity::MainMenus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Szenen</translation>
    </message>
    <message>
        <source>Fi&amp;gures</source>
        <translation>Abbildun&amp;gen</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Lauf</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Curve</source>
        <translation>&amp;Kurve</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>Same as system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>More commands</source>
        <translation>Weitere Befehle</translation>
    </message>
</context>
<context>
    <name>asperity::MainWindow</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>close</source>
        <translation>schließen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>Sets the time to 0 and keeps the parameters</source>
        <translation>Setzt die Zeit auf 0 und behält die Parameter</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Asperity[*]</source>
        <translation>Asperity[*]</translation>
    </message>
    <message>
        <source>%1[*] – Asperity</source>
        <translation>%1[*] – Asperity</translation>
    </message>
    <message>
        <source>Fine step</source>
        <translation>Feiner Schritt</translation>
    </message>
    <message>
        <source>Describe the contact in words</source>
        <translation>Kontakt in Worten beschreiben</translation>
    </message>
</context>
<context>
    <name>asperity::MapPanel</name>
    <message>
        <source>%1 lines, %2 % done</source>
        <translation>%1 Linien, %2 % fertig</translation>
    </message>
    <message>
        <source>The map is being computed…</source>
        <translation>Die Karte wird berechnet…</translation>
    </message>
    <message>
        <source>Shown: the mean of %1 of %2 lines. </source>
        <translation>Gezeigt: das Mittel über %1 von %2 Linien. </translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % of the map over all lines are computed. It can be saved then: what is shown until then is a mean of fewer lines.</source>
        <translation>%1 % der Karte über alle Linien sind berechnet. Erst dann lässt sie sich speichern: Was bis dahin zu sehen ist, ist ein Mittel über weniger Linien.</translation>
    </message>
    <message>
        <source>Show:</source>
        <translation>Anzeige:</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>Speichern…</translation>
    </message>
    <message>
        <source>without the target error</source>
        <translation>ohne Zielfehler</translation>
    </message>
    <message>
        <source>All cells of a map have the same lines, those that the scene states.</source>
        <translation>Alle Zellen einer Karte haben dieselben Linien, nämlich die der Szene.</translation>
    </message>
    <message>
        <source>friction over two parameters</source>
        <translation>Reibung über zwei Parametern</translation>
    </message>
    <message>
        <source>parameter along x</source>
        <translation>Parameter entlang x</translation>
    </message>
    <message>
        <source>parameter along y</source>
        <translation>Parameter entlang y</translation>
    </message>
    <message>
        <source>Save the map as a picture or a table, once it is computed</source>
        <translation>Die Karte als Bild oder Tabelle speichern, sobald sie berechnet ist</translation>
    </message>
</context>
<context>
    <name>asperity::MaterialBox</name>
    <message>
        <source>own values</source>
        <translation>eigene Werte</translation>
    </message>
    <message>
        <source>Open material…</source>
        <translation>Material öffnen…</translation>
    </message>
</context>
<context>
    <name>asperity::MaterialImport</name>
    <message>
        <source>summary of the material</source>
        <translation>Zusammenfassung des Materials</translation>
    </message>
    <message>
        <source>Save material</source>
        <translation>Material speichern</translation>
    </message>
    <message>
        <source>Materials (*.json)</source>
        <translation>Materialien (*.json)</translation>
    </message>
    <message>
        <source>&amp;Save and use…</source>
        <translation>&amp;Speichern und verwenden…</translation>
    </message>
    <message>
        <source>Open material</source>
        <translation>Material öffnen</translation>
    </message>
    <message>
        <source>the measured moduli and their fit</source>
        <translation>die gemessenen Moduln und ihre Anpassung</translation>
    </message>
    <message>
        <source>Unit of the frequencies</source>
        <translation>Einheit der Frequenzen</translation>
    </message>
    <message>
        <source>Unit of the temperatures</source>
        <translation>Einheit der Temperaturen</translation>
    </message>
    <message>
        <source>Unit of the moduli</source>
        <translation>Einheit der Moduln</translation>
    </message>
    <message>
        <source>Whether the moduli are of shear (G) or of tension (E)</source>
        <translation>Ob die Moduln für Schub (G) oder für Zug (E) gelten</translation>
    </message>
    <message>
        <source>Poisson&apos;s ratio</source>
        <translation>Querkontraktionszahl</translation>
    </message>
    <message>
        <source>Turns moduli of tension into those of shear: G = E / (2 (1 + ν))</source>
        <translation>Macht aus Zugmoduln Schubmoduln: G = E / (2 (1 + ν))</translation>
    </message>
    <message>
        <source>Temperature of a file that does not state one, such as 20 °C</source>
        <translation>Temperatur einer Datei, die keine nennt, etwa 20 °C</translation>
    </message>
    <message>
        <source>Master curve</source>
        <translation>Masterkurve</translation>
    </message>
    <message>
        <source>Temperature to which all isotherms are shifted, such as 20 °C</source>
        <translation>Temperatur, zu der alle Isothermen verschoben werden, etwa 20 °C</translation>
    </message>
    <message>
        <source>near 25 °C</source>
        <translation>nahe 25 °C</translation>
    </message>
    <message>
        <source>vertical shifts, too</source>
        <translation>auch senkrecht verschieben</translation>
    </message>
    <message>
        <source>Prony series</source>
        <translation>Prony-Reihe</translation>
    </message>
    <message>
        <source>Relaxation times, evenly spaced in their logarithm</source>
        <translation>Relaxationszeiten mit gleichen Abständen im Logarithmus</translation>
    </message>
    <message>
        <source>name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the material</source>
        <translation>Name des Materials</translation>
    </message>
    <message>
        <source>source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Where the measurements come from, so that a reader can look it up</source>
        <translation>Woher die Messungen stammen, sodass Leser nachsehen können</translation>
    </message>
    <message>
        <source>Isotherms</source>
        <translation>Isothermen</translation>
    </message>
    <message>
        <source>Loss tangent</source>
        <translation>Verlustfaktor</translation>
    </message>
    <message>
        <source>Shifts</source>
        <translation>Verschiebungen</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>aus der Datei</translation>
    </message>
    <message>
        <source>The measurement</source>
        <translation>Die Messung</translation>
    </message>
    <message>
        <source>unit of frequency</source>
        <translation>Einheit der Frequenz</translation>
    </message>
    <message>
        <source>unit of temperature</source>
        <translation>Einheit der Temperatur</translation>
    </message>
    <message>
        <source>unit of modulus</source>
        <translation>Einheit des Moduls</translation>
    </message>
    <message>
        <source>kind of modulus</source>
        <translation>Art des Moduls</translation>
    </message>
    <message>
        <source>test temperature</source>
        <translation>Messtemperatur</translation>
    </message>
    <message>
        <source>instantaneous modulus G₀</source>
        <translation>Momentanmodul G₀</translation>
    </message>
    <message>
        <source>Shear modulus in Pa or MPa of a series that gives parts of it</source>
        <translation>Schubmodul in Pa oder MPa zu einer Reihe, die Anteile davon nennt</translation>
    </message>
    <message>
        <source>Columns of the table</source>
        <translation>Spalten der Tabelle</translation>
    </message>
    <message>
        <source>Name of the column, or its number from 1 on</source>
        <translation>Name der Spalte oder ihre Nummer, von 1 an gezählt</translation>
    </message>
    <message>
        <source>frequency column</source>
        <translation>Spalte der Frequenz</translation>
    </message>
    <message>
        <source>temperature column</source>
        <translation>Spalte der Temperatur</translation>
    </message>
    <message>
        <source>storage modulus column</source>
        <translation>Spalte Speichermodul</translation>
    </message>
    <message>
        <source>loss modulus column</source>
        <translation>Spalte Verlustmodul</translation>
    </message>
    <message>
        <source>loss tangent column</source>
        <translation>Spalte Verlustfaktor</translation>
    </message>
    <message>
        <source>found by its name</source>
        <translation>am Namen erkannt</translation>
    </message>
    <message>
        <source>reference temperature</source>
        <translation>Bezugstemperatur</translation>
    </message>
    <message>
        <source>temperature shift</source>
        <translation>Temperaturverschiebung</translation>
    </message>
    <message>
        <source>How the material keeps the shifts with temperature: by the formula of Williams, Landel and Ferry, by that of Arrhenius, or as their table</source>
        <translation>Wie das Material die Verschiebungen mit der Temperatur enthält: nach der Formel von Williams, Landel und Ferry, nach der von Arrhenius oder als ihre Tabelle</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>as few as needed</source>
        <translation>so wenige wie nötig</translation>
    </message>
    <message>
        <source>number of terms</source>
        <translation>Zahl der Glieder</translation>
    </message>
    <message>
        <source>equilibrium modulus G∞</source>
        <translation>Gleichgewichtsmodul G∞</translation>
    </message>
    <message>
        <source>Shear modulus in Pa or MPa where it is known from elsewhere</source>
        <translation>Schubmodul in Pa oder MPa, wenn er von anderswo bekannt ist</translation>
    </message>
    <message>
        <source>from the fit</source>
        <translation>aus der Anpassung</translation>
    </message>
    <message>
        <source>allow G∞ = 0 (a liquid)</source>
        <translation>G∞ = 0 zulassen (Flüssigkeit)</translation>
    </message>
    <message>
        <source>Whether the material may flow, without an equilibrium modulus</source>
        <translation>Ob das Material fließen darf, also keinen Gleichgewichtsmodul hat</translation>
    </message>
    <message>
        <source>The material file</source>
        <translation>Die Materialdatei</translation>
    </message>
</context>
<context>
    <name>asperity::MessageBar</name>
    <message>
        <source>less</source>
        <translation>weniger</translation>
    </message>
    <message>
        <source>more</source>
        <translation>mehr</translation>
    </message>
    <message>
        <source>close message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>not possible; the message above says why</source>
        <translation>nicht möglich; den Grund nennt die Meldung oben</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>annehmen</translation>
    </message>
    <message>
        <source>%1, row %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
</context>
<context>
    <name>asperity::MotionView</name>
    <message>
        <source>loop of friction over velocity</source>
        <translation>Schleife der Reibung über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>in contact %1 %</source>
        <translation>in Kontakt %1 %</translation>
    </message>
    <message>
        <source>normal force %1</source>
        <translation>Normalkraft %1</translation>
    </message>
    <message>
        <source>velocity, friction, indentation and length per contact in time</source>
        <translation>Geschwindigkeit, Reibung, Eindringung und Länge je Kontakt über der Zeit</translation>
    </message>
</context>
<context>
    <name>asperity::PairEditor</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1, %2 to %3</source>
        <translation>%1, %2 bis %3</translation>
    </message>
    <message>
        <source>Fold the table away</source>
        <translation>Tabelle einklappen</translation>
    </message>
    <message>
        <source>Open the table</source>
        <translation>Tabelle aufklappen</translation>
    </message>
</context>
<context>
    <name>asperity::PanelBar</name>
    <message>
        <source>Essentials</source>
        <translation>Wesentliches</translation>
    </message>
    <message>
        <source>The few parameters that matter first: velocity, load, stiffness, roughness</source>
        <translation>Die wenigen Größen, auf die es zuerst ankommt: Geschwindigkeit, Last, Steifigkeit, Rauheit</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>All parameters of this scene, in sections</source>
        <translation>Alle Parameter dieser Szene, in Abschnitten</translation>
    </message>
    <message>
        <source>search in the parameters</source>
        <translation>Suche in den Parametern</translation>
    </message>
    <message>
        <source>Words of a label or a key, a symbol or a unit: “force”, “surface”, “G”, “mN”. Escape clears.</source>
        <translation>Wörter einer Bezeichnung oder eines Schlüssels, ein Formelzeichen oder eine Einheit: „kraft“, „surface“, „G“, „mN“. Escape löscht.</translation>
    </message>
    <message>
        <source>Search ( / )</source>
        <translation>Suchen ( / )</translation>
    </message>
    <message>
        <source>clear the search</source>
        <translation>Suche löschen</translation>
    </message>
</context>
<context>
    <name>asperity::ParameterPanel</name>
    <message>
        <source>chosen: %1</source>
        <translation>gewählt: %1</translation>
    </message>
    <message>
        <source>a tenth</source>
        <translation>10 %</translation>
    </message>
    <message>
        <source>as in file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>choose a profile file</source>
        <translation>Profildatei wählen</translation>
    </message>
    <message>
        <source>every row</source>
        <translation>jede Zeile</translation>
    </message>
    <message>
        <source>choose a file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>choose the kind of spectrum</source>
        <translation>Art des Spektrums wählen</translation>
    </message>
    <message>
        <source>Choose a file of the line</source>
        <translation>Datei der Linie wählen</translation>
    </message>
    <message>
        <source>Tables (*.csv *.txt);;All files (*)</source>
        <translation>Tabellen (*.csv *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>all rows</source>
        <translation>alle Zeilen</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 (curve: %2)</source>
        <translation>%1 (Kurve: %2)</translation>
    </message>
    <message>
        <source>not set</source>
        <translation>offen</translation>
    </message>
</context>
<context>
    <name>asperity::ParameterRow</name>
    <message>
        <source>Back to the default, one arm</source>
        <translation>Zurück zur Vorgabe, ein Arm</translation>
    </message>
    <message>
        <source>Back to the default, %1</source>
        <translation>Zurück zur Vorgabe, %1</translation>
    </message>
    <message>
        <source>no file</source>
        <translation>keine Datei</translation>
    </message>
    <message>
        <source>Choose a file of this computer</source>
        <translation>Eine Datei dieses Rechners wählen</translation>
    </message>
    <message>
        <source>choose file</source>
        <translation>Datei wählen</translation>
    </message>
    <message>
        <source>reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Back to the default, chosen by the scene</source>
        <translation>Zurück zur Vorgabe, von der Szene gewählt</translation>
    </message>
    <message>
        <source>choose file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>A number alone counts in the unit beside it; any unit may be typed with it.</source>
        <translation>Eine Zahl allein zählt in der Einheit daneben; dazu kann jede Einheit geschrieben werden.</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>“%1” is not a number; allowed is %2</source>
        <translation>„%1“ ist keine Zahl; erlaubt ist %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number; allowed is %2</source>
        <translation>%1 ist keine ganze Zahl; erlaubt ist %2</translation>
    </message>
    <message>
        <source>%1 is outside %2</source>
        <translation>%1 liegt außerhalb von %2</translation>
    </message>
    <message>
        <source>Read about it in the guide</source>
        <translation>Im Handbuch nachlesen</translation>
    </message>
    <message>
        <source>Back to the default, which is empty</source>
        <translation>Zurück zur Vorgabe, die leer ist</translation>
    </message>
    <message>
        <source>Arrow keys make steps, with Shift the smallest ones; PageUp and PageDown large ones.</source>
        <translation>Pfeiltasten machen Schritte, mit Umschalt die kleinsten; Bild auf und Bild ab große.</translation>
    </message>
    <message>
        <source>Dragging with Shift is ten times finer.</source>
        <translation>Ziehen mit Umschalt ist zehnmal feiner.</translation>
    </message>
    <message>
        <source>slider: %1</source>
        <translation>Regler: %1</translation>
    </message>
    <message>
        <source>values: %1</source>
        <translation>Werte: %1</translation>
    </message>
    <message>
        <source>key in scene files: %1; %2</source>
        <translation>Schlüssel in Szenendateien: %1; %2</translation>
    </message>
</context>
<context>
    <name>asperity::PlanList</name>
    <message>
        <source>which stages run, and why</source>
        <translation>welche Stufen laufen und warum</translation>
    </message>
    <message>
        <source>stage</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>because</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
</context>
<context>
    <name>asperity::PointText</name>
    <message>
        <source>in contact %1 %</source>
        <translation>in Kontakt %1 %</translation>
    </message>
    <message>
        <source>with local friction: %1</source>
        <translation>mit lokaler Reibung: %1</translation>
    </message>
    <message>
        <source>Eq. (11): %1</source>
        <translation>Gl. (11): %1</translation>
    </message>
    <message>
        <source>difference %1</source>
        <translation>Unterschied %1</translation>
    </message>
    <message>
        <source>with %1</source>
        <translation>mit %1</translation>
    </message>
    <message>
        <source>computed: %1</source>
        <translation>berechnet: %1</translation>
    </message>
</context>
<context>
    <name>asperity::PredictionFields</name>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>a choice</source>
        <translation>eine Auswahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>a point on the chart</source>
        <translation>ein Punkt im Diagramm</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Place on the axis</source>
        <translation>Stelle auf der Achse</translation>
    </message>
    <message>
        <source>empty: the largest value is asked</source>
        <translation>leer: nach dem größten Wert wird gefragt</translation>
    </message>
    <message>
        <source>If right</source>
        <translation>Wenn richtig</translation>
    </message>
    <message>
        <source>If wrong</source>
        <translation>Wenn falsch</translation>
    </message>
    <message>
        <source>choices</source>
        <translation>Antworten zur Auswahl</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Tick the right one; or leave all unticked, give the range of the computed answer for which each is right, and say below what is computed</source>
        <translation>Haken Sie die richtige an; oder lassen Sie alle ohne Haken, geben Sie für jede an, in welchem Bereich der berechneten Antwort sie richtig ist, und unten, was berechnet wird</translation>
    </message>
    <message>
        <source>Choices</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Tolerance in %</source>
        <translation>Toleranz in %</translation>
    </message>
    <message>
        <source>How far a right answer may be from the computed one; of a point, the factor on the chart is 1.5 for 50 %</source>
        <translation>Wie weit eine richtige Antwort von der berechneten entfernt sein darf; bei einem Punkt heißen 50 % ein Faktor 1,5 im Diagramm</translation>
    </message>
    <message>
        <source>The curve is</source>
        <translation>Die Kurve ist</translation>
    </message>
    <message>
        <source>in sight</source>
        <translation>zu sehen</translation>
    </message>
    <message>
        <source>hidden until the answer</source>
        <translation>bis zur Antwort verborgen</translation>
    </message>
    <message>
        <source>hidden throughout</source>
        <translation>immer verborgen</translation>
    </message>
    <message>
        <source>Changed with the answer</source>
        <translation>Mit der Antwort geändert</translation>
    </message>
    <message>
        <source>What the program changes in the scene when the answer is shown</source>
        <translation>Was das Programm an der Szene ändert, wenn die Antwort gezeigt wird</translation>
    </message>
    <message>
        <source>Said with the answer</source>
        <translation>Mit der Antwort gesagt</translation>
    </message>
    <message>
        <source>{answer}: the right answer; {given}: that of the student</source>
        <translation>{answer}: die richtige Antwort; {given}: die der Lernenden</translation>
    </message>
    <message>
        <source>Tolerance of the place in %</source>
        <translation>Toleranz der Stelle in %</translation>
    </message>
    <message>
        <source>How far the place of a right answer may be from that of the largest value: the factor is 2 for 100 %</source>
        <translation>Wie weit die Stelle einer richtigen Antwort von der des größten Wertes entfernt sein darf: 100 % heißen ein Faktor 2</translation>
    </message>
    <message>
        <source>%1: “%2” is not a number</source>
        <translation>%1: „%2“ ist keine Zahl</translation>
    </message>
    <message>
        <source>Choice %1, %2: “%3” is not a number</source>
        <translation>Antwort %1, %2: „%3“ ist keine Zahl</translation>
    </message>
    <message>
        <source>Write {answer} where the computed answer or the right choice belongs, and {given} where the student&apos;s does; *italic*, **bold**</source>
        <translation>Schreiben Sie {answer}, wo die berechnete oder die richtige Antwort stehen soll, und {given}, wo die der Lernenden stehen soll; *kursiv*, **fett**</translation>
    </message>
</context>
<context>
    <name>asperity::PredictionPoint</name>
    <message>
        <source>Drag up and down, or use the arrow keys (with Shift finer)</source>
        <translation>Ziehe hinauf und hinunter, oder nimm die Pfeiltasten (mit Umschalt feiner)</translation>
    </message>
    <message>
        <source>Drag, or use the arrow keys (with Shift finer)</source>
        <translation>Ziehe, oder nimm die Pfeiltasten (mit Umschalt feiner)</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>your answer</source>
        <translation>deine Antwort</translation>
    </message>
    <message>
        <source>drag me</source>
        <translation>zieh mich</translation>
    </message>
</context>
<context>
    <name>asperity::RowList</name>
    <message>
        <source>Rigid line</source>
        <translation>Starre Linie</translation>
    </message>
    <message>
        <source>Elastomer</source>
        <translation>Elastomer</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Sliding</source>
        <translation>Gleiten</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Grenzfläche</translation>
    </message>
    <message>
        <source>Friction curve</source>
        <translation>Reibungskurve</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>Texts of the scene</source>
        <translation>Texte der Szene</translation>
    </message>
    <message>
        <source>No parameter of this scene has “%1”. Escape clears the search.</source>
        <translation>Kein Parameter dieser Szene hat „%1“. Escape löscht die Suche.</translation>
    </message>
    <message>
        <source>Nothing is changed here in this step.</source>
        <translation>In diesem Schritt wird hier nichts verändert.</translation>
    </message>
</context>
<context>
    <name>asperity::SceneCardText</name>
    <message>
        <source>Only the highest summits touch, and the rubber comes back late behind each of them.</source>
        <translation>Nur die höchsten Gipfel haben Kontakt, und hinter jedem kommt das Gummi verspätet zurück.</translation>
    </message>
    <message>
        <source>Friction grows with the velocity, bends into a plateau and falls again.</source>
        <translation>Die Reibung wächst mit der Geschwindigkeit, biegt in ein Plateau ein und fällt wieder.</translation>
    </message>
    <message>
        <source>The rubber presses on the front of the summit and is not back yet behind it.</source>
        <translation>Das Gummi drückt vorn auf den Gipfel und ist dahinter noch nicht zurück.</translation>
    </message>
    <message>
        <source>Nothing slides: contact is even on both sides of each summit, and there is no friction.</source>
        <translation>Nichts gleitet: Der Kontakt ist auf beiden Seiten jedes Gipfels gleich, und es gibt keine Reibung.</translation>
    </message>
    <message>
        <source>Slow: both sides of each summit touch, and friction doubles when the velocity doubles.</source>
        <translation>Langsam: Jeder Gipfel hat auf beiden Seiten Kontakt, und die Reibung verdoppelt sich, wenn sich die Geschwindigkeit verdoppelt.</translation>
    </message>
    <message>
        <source>Contact begins to leave the rear sides of the summits, and the straight line bends.</source>
        <translation>Der Kontakt beginnt die Rückseiten der Gipfel zu verlassen, und die Gerade biegt sich.</translation>
    </message>
    <message>
        <source>Only front sides touch: friction hardly depends on velocity, modulus or force.</source>
        <translation>Nur die Vorderseiten haben Kontakt: Die Reibung hängt kaum von Geschwindigkeit, Modul oder Kraft ab.</translation>
    </message>
    <message>
        <source>A few tips carry everything, and friction falls although sliding is faster.</source>
        <translation>Wenige Kuppen tragen alles, und die Reibung fällt, obwohl die Linie schneller gleitet.</translation>
    </message>
    <message>
        <source>Contact moves to the front of the summit when you raise the velocity.</source>
        <translation>Der Kontakt wandert auf die Vorderseite des Gipfels, wenn man die Geschwindigkeit erhöht.</translation>
    </message>
    <message>
        <source>Many summits of one size instead of a landscape: a steeper line has more friction.</source>
        <translation>Viele Gipfel einer Größe statt einer Landschaft: Eine steilere Linie hat mehr Reibung.</translation>
    </message>
    <message>
        <source>Fine roughness on the summits counts at once, even under a light load.</source>
        <translation>Feine Rauheit auf den Gipfeln zählt sofort, auch unter leichter Last.</translation>
    </message>
    <message>
        <source>Fine roughness in the valleys counts only when the load presses the rubber into them.</source>
        <translation>Feine Rauheit in den Tälern zählt erst, wenn die Last das Gummi hineindrückt.</translation>
    </message>
    <message>
        <source>Raise the velocity: friction reaches the slope of the flank and stays there.</source>
        <translation>Die Geschwindigkeit erhöhen: Die Reibung erreicht die Steigung der Flanke und bleibt dort.</translation>
    </message>
    <message>
        <source>Without memory the rubber gives back what it took: no friction at any velocity.</source>
        <translation>Ohne Gedächtnis gibt das Gummi zurück, was es aufnahm: keine Reibung bei jeder Geschwindigkeit.</translation>
    </message>
    <message>
        <source>A constant share of the interface is added to what the deformation costs.</source>
        <translation>Ein fester Anteil der Grenzfläche kommt zu dem hinzu, was die Verformung kostet.</translation>
    </message>
    <message>
        <source>One share falls with the contact while the other rises: find where they cross.</source>
        <translation>Ein Anteil fällt mit dem Kontakt, während der andere steigt: Wo kreuzen sie sich?</translation>
    </message>
    <message>
        <source>Each arm of the rubber makes a shoulder in the friction curve.</source>
        <translation>Jeder Arm des Gummis macht eine Schulter in der Reibungskurve.</translation>
    </message>
    <message>
        <source>One arm makes one broad peak: fast rubber is as elastic as slow rubber, only stiffer.</source>
        <translation>Ein Arm ergibt ein breites Maximum: Bei schnellem Gleiten ist das Gummi so elastisch wie bei langsamem, nur steifer.</translation>
    </message>
    <message>
        <source>Cold rubber has its friction at lower velocities; the shape of the curve stays.</source>
        <translation>Kaltes Gummi hat seine Reibung bei kleineren Geschwindigkeiten; die Form der Kurve bleibt.</translation>
    </message>
    <message>
        <source>Move the temperature: the whole curve slides along the velocity.</source>
        <translation>Die Temperatur ändern: Die ganze Kurve wandert entlang der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Warm rubber needs a higher velocity for the same friction.</source>
        <translation>Warmes Gummi braucht für dieselbe Reibung eine höhere Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Thirteen arms spread the rise of friction over ten decades of velocity.</source>
        <translation>Dreizehn Arme verteilen den Anstieg der Reibung über zehn Dekaden der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Friction vanishes for slow and for fast sliding: there the rubber is elastic.</source>
        <translation>Die Reibung verschwindet bei langsamem und bei schnellem Gleiten: Dort ist das Gummi elastisch.</translation>
    </message>
    <message>
        <source>At the same velocity, friction on the way up differs from friction on the way down.</source>
        <translation>Bei derselben Geschwindigkeit ist die Reibung beim Beschleunigen eine andere als beim Abbremsen.</translation>
    </message>
    <message>
        <source>The line turns back into its own dents: friction is first too small, then settles.</source>
        <translation>Die Linie kehrt in ihre eigenen Dellen zurück: Die Reibung ist erst zu klein und pendelt sich ein.</translation>
    </message>
    <message>
        <source>Friction begins above its steady value and settles while the line is lifted.</source>
        <translation>Die Reibung beginnt über ihrem stationären Wert und sinkt, während die Linie angehoben wird.</translation>
    </message>
    <message>
        <source>Friction shoots to more than twice its steady value before the rubber relaxes.</source>
        <translation>Die Reibung schießt auf mehr als das Doppelte, bevor das Gummi relaxiert.</translation>
    </message>
    <message>
        <source>The line stops at half time, but the force needs a relaxation time to vanish.</source>
        <translation>Die Linie hält nach der halben Zeit an, aber die Kraft braucht eine Relaxationszeit, um zu verschwinden.</translation>
    </message>
    <message>
        <source>At twice the velocity friction first jumps and then relaxes.</source>
        <translation>Bei doppelter Geschwindigkeit springt die Reibung zuerst und relaxiert dann.</translation>
    </message>
    <message>
        <source>A single contact relaxes along one exponential curve.</source>
        <translation>Ein einzelner Kontakt relaxiert entlang einer einzigen Exponentialkurve.</translation>
    </message>
    <message>
        <source>Two models of the same rubber: see where they agree and where they do not.</source>
        <translation>Zwei Modelle desselben Gummis: Wo stimmen sie überein und wo nicht?</translation>
    </message>
    <message>
        <source>The rubber fills every valley, and friction is known exactly.</source>
        <translation>Das Gummi füllt jedes Tal, und die Reibung ist genau bekannt.</translation>
    </message>
    <message>
        <source>The friction curve of a single wave is the loss modulus of the rubber.</source>
        <translation>Die Reibungskurve einer einzelnen Welle ist der Verlustmodul des Gummis.</translation>
    </message>
    <message>
        <source>Raise the velocity and watch the rubber leave the rear of each grain.</source>
        <translation>Die Geschwindigkeit erhöhen und zusehen, wie das Gummi die Rückseite jedes Korns verlässt.</translation>
    </message>
    <message>
        <source>Beyond the maximum, a foot that begins to slip has less and less friction.</source>
        <translation>Jenseits des Maximums hat ein Fuß, der zu rutschen beginnt, immer weniger Reibung.</translation>
    </message>
    <message>
        <source>Each stone is touched on its front only: that is the friction of a tyre.</source>
        <translation>Jeder Stein wird nur vorn berührt: Das ist die Reibung eines Reifens.</translation>
    </message>
</context>
<context>
    <name>asperity::SceneDocument</name>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>All parameters</source>
        <translation>Alle Parameter</translation>
    </message>
    <message>
        <source>Revert to the opened scene</source>
        <translation>Zurück zur geöffneten Fassung</translation>
    </message>
    <message>
        <source>%1 parameters</source>
        <translation>%1 Parameter</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Oberfläche öffnen</translation>
    </message>
    <message>
        <source>Open material</source>
        <translation>Material öffnen</translation>
    </message>
    <message>
        <source>Add measured friction</source>
        <translation>Gemessene Reibung hinzufügen</translation>
    </message>
    <message>
        <source>Theories</source>
        <translation>Theorien</translation>
    </message>
    <message>
        <source>Remove measured friction</source>
        <translation>Gemessene Reibung entfernen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>Axis of the curve</source>
        <translation>Achse der Kurve</translation>
    </message>
    <message>
        <source>Other scene</source>
        <translation>Andere Szene</translation>
    </message>
    <message>
        <source>Scene “%1”</source>
        <translation>Szene „%1“</translation>
    </message>
</context>
<context>
    <name>asperity::SceneGallery</name>
    <message>
        <source>Choose a scene to begin with; everything in it can be changed</source>
        <translation>Eine Szene für den Anfang wählen; alles darin lässt sich ändern</translation>
    </message>
    <message>
        <source>search in the scenes</source>
        <translation>Suche in den Szenen</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>No scene has these words. Escape clears them.</source>
        <translation>Keine Szene enthält diese Wörter. Escape löscht sie.</translation>
    </message>
    <message>
        <source>Search ( / )</source>
        <translation>Suchen ( / )</translation>
    </message>
</context>
<context>
    <name>asperity::SceneTabs</name>
    <message>
        <source>about the scene</source>
        <translation>über die Szene</translation>
    </message>
    <message>
        <source>%1: hidden until the answer</source>
        <translation>%1: verborgen bis zur Antwort</translation>
    </message>
    <message>
        <source>coefficient of friction against velocity</source>
        <translation>Reibungszahl über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>spectrum of the rigid line</source>
        <translation>Spektrum der starren Linie</translation>
    </message>
    <message>
        <source>line loads and slopes in contact</source>
        <translation>Linienlasten und Steigungen im Kontakt</translation>
    </message>
    <message>
        <source>Friction curve</source>
        <translation>Reibungskurve</translation>
    </message>
    <message>
        <source>Motion in time</source>
        <translation>Zeitverlauf</translation>
    </message>
    <message>
        <source>Spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Tabs</source>
        <translation>Reiter</translation>
    </message>
    <message>
        <source>moduli of the elastomer and the frequencies in use</source>
        <translation>Moduln des Elastomers und die genutzten Frequenzen</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Influences</source>
        <translation>Einflüsse</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>Motion</source>
        <translation>Verlauf</translation>
    </message>
</context>
<context>
    <name>asperity::SectionHeader</name>
    <message>
        <source>%1 changed</source>
        <translation>%1 geändert</translation>
    </message>
    <message>
        <source>open section</source>
        <translation>offener Abschnitt</translation>
    </message>
    <message>
        <source>folded section</source>
        <translation>zugeklappter Abschnitt</translation>
    </message>
    <message>
        <source>folded section, %1</source>
        <translation>zugeklappter Abschnitt, %1</translation>
    </message>
    <message>
        <source>Fold this section</source>
        <translation>Diesen Abschnitt zuklappen</translation>
    </message>
    <message>
        <source>Open this section</source>
        <translation>Diesen Abschnitt aufklappen</translation>
    </message>
</context>
<context>
    <name>asperity::ShiftEditor</name>
    <message>
        <source>clipboard</source>
        <translation>Zwischenablage</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>temperature of row %1</source>
        <translation>Temperatur der Zeile %1</translation>
    </message>
    <message>
        <source>log10 of the shift of row %1</source>
        <translation>log10 der Verschiebung in Zeile %1</translation>
    </message>
    <message>
        <source>Add row</source>
        <translation>Zeile hinzufügen</translation>
    </message>
    <message>
        <source>One more row, 10 K above the highest temperature</source>
        <translation>Eine weitere Zeile, 10 K über der höchsten Temperatur</translation>
    </message>
    <message>
        <source>Paste table</source>
        <translation>Tabelle einfügen</translation>
    </message>
    <message>
        <source>Two columns from the clipboard, as a spreadsheet copies them, replace the table: temperature in K or °C and log10 of the shift, or as names and units in the first row say</source>
        <translation>Zwei Spalten aus der Zwischenablage, wie eine Tabellenkalkulation sie kopiert, ersetzen die Tabelle: Temperatur in K oder °C und log10 der Verschiebung, oder wie Namen und Einheiten der ersten Zeile es sagen</translation>
    </message>
    <message>
        <source>Remove this row</source>
        <translation>Diese Zeile entfernen</translation>
    </message>
    <message>
        <source>remove row %1</source>
        <translation>Zeile %1 entfernen</translation>
    </message>
    <message>
        <source>shift table: %1</source>
        <translation>Verschiebungstabelle: %1</translation>
    </message>
    <message>
        <source>one</source>
        <translation>eine</translation>
    </message>
</context>
<context>
    <name>asperity::ShortcutSheet</name>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Contact: mouse and touch</source>
        <translation>Kontakt: Maus und Finger</translation>
    </message>
    <message>
        <source>Zoom at the pointer</source>
        <translation>Am Zeiger vergrößern</translation>
    </message>
    <message>
        <source>Wheel or pinch</source>
        <translation>Rad oder Spreizen</translation>
    </message>
    <message>
        <source>Vertical exaggeration</source>
        <translation>Überhöhung</translation>
    </message>
    <message>
        <source>Ctrl+Wheel</source>
        <translation>Strg+Rad</translation>
    </message>
    <message>
        <source>Move along the line</source>
        <translation>Entlang der Linie</translation>
    </message>
    <message>
        <source>Shift+Wheel</source>
        <translation>Umschalt+Rad</translation>
    </message>
    <message>
        <source>Move the view</source>
        <translation>Ansicht verschieben</translation>
    </message>
    <message>
        <source>Drag or arrow keys</source>
        <translation>Ziehen oder Pfeiltasten</translation>
    </message>
    <message>
        <source>Press harder or less</source>
        <translation>Stärker oder schwächer drücken</translation>
    </message>
    <message>
        <source>Drag the body or its arrow up or down</source>
        <translation>Körper oder seinen Pfeil auf oder ab ziehen</translation>
    </message>
    <message>
        <source>Slide faster or slower</source>
        <translation>Schneller oder langsamer gleiten</translation>
    </message>
    <message>
        <source>Drag the arrow of the velocity</source>
        <translation>Pfeil der Geschwindigkeit ziehen</translation>
    </message>
    <message>
        <source>Move the crosshair</source>
        <translation>Fadenkreuz bewegen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>Double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>Curve: mouse and touch</source>
        <translation>Kurve: Maus und Finger</translation>
    </message>
    <message>
        <source>Zoom, over an axis along it</source>
        <translation>Vergrößern, an Achsen nur diese</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>Move curve or marker</source>
        <translation>Kurve oder Markierung ziehen</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>Slower or faster</source>
        <translation>Langsamer oder schneller</translation>
    </message>
    <message>
        <source>Velocity of a point</source>
        <translation>Geschwindigkeit eines Punkts</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Fit axes</source>
        <translation>Achsen einpassen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Ctrl+← or →</source>
        <translation>Strg+← oder →</translation>
    </message>
    <message>
        <source>← or →</source>
        <translation>← oder →</translation>
    </message>
</context>
<context>
    <name>asperity::StatusLine</name>
    <message>
        <source>, mean of %1: %2 ± %3 %</source>
        <translation>, Mittel über %1: %2 ± %3 %</translation>
    </message>
    <message>
        <source>, mean of %1 ≈ %2 ± %3 %</source>
        <translation>, Mittel über %1 ≈ %2 ± %3 %</translation>
    </message>
    <message>
        <source>Eq. (13) of the paper: relaxation time × velocity × rms slope / (√2 × rms height); of a motion at this moment</source>
        <translation>Gl. (13) der Arbeit: Relaxationszeit × Geschwindigkeit × RMS-Steigung / (√2 × RMS-Höhe); bei einer Bewegung in diesem Augenblick</translation>
    </message>
    <message>
        <source>Where the velocity lies on the friction curve: regions I to IV of the paper, found on the complete curve</source>
        <translation>Wo die Geschwindigkeit auf der Reibungskurve liegt: Bereiche I bis IV der Arbeit, gefunden auf der vollständigen Kurve</translation>
    </message>
    <message>
        <source>Coefficient of friction of this line, of a motion at this moment; then the mean of all lines at this velocity with its standard error. After ≈ it is interpolated between two points of the curve.</source>
        <translation>Reibungszahl dieser Linie, bei einer Bewegung in diesem Augenblick; dahinter das Mittel aller Linien bei dieser Geschwindigkeit mit seinem Standardfehler. Nach ≈ ist es zwischen zwei Punkten der Kurve interpoliert.</translation>
    </message>
    <message>
        <source>Eq. (14) of the paper: normal force / (shear modulus × rms height × period)</source>
        <translation>Gl. (14) der Arbeit: Normalkraft / (Schubmodul × RMS-Höhe × Periode)</translation>
    </message>
    <message>
        <source>No velocity v̄ here: an elastic body has no relaxation time.</source>
        <translation>Hier keine Geschwindigkeit v̄: Ein elastischer Körper hat keine Relaxationszeit.</translation>
    </message>
    <message>
        <source>No velocity v̄ here: arms have relaxation times of their own, and Eq. (13) is made with the only one of the paper&apos;s elastomer.</source>
        <translation>Hier keine Geschwindigkeit v̄: Arme haben eigene Relaxationszeiten, und Gl. (13) ist mit der einzigen des Elastomers der Arbeit gebildet.</translation>
    </message>
    <message>
        <source>No velocity v̄ here: the line has no roughness.</source>
        <translation>Hier keine Geschwindigkeit v̄: Die Linie hat keine Rauheit.</translation>
    </message>
    <message>
        <source>The picture is moving from the previous scene to the steady state that these numbers and the chart describe. R shows that state at once.</source>
        <translation>Das Bild ist auf dem Weg von der Szene davor in den stationären Zustand, zu dem diese Zahlen und das Diagramm gehören. R zeigt ihn sofort.</translation>
    </message>
    <message>
        <source>Lines computed per second for the curve, each at one velocity</source>
        <translation>Linien bei je einer Geschwindigkeit, die in einer Sekunde für die Kurve berechnet werden</translation>
    </message>
    <message>
        <source>Pictures of the contact shown in the last second</source>
        <translation>In der letzten Sekunde gezeigte Bilder des Kontakts</translation>
    </message>
    <message>
        <source>What draws the contact: the program itself (software) or the graphics card (OpenGL)</source>
        <translation>Was den Kontakt zeichnet: das Programm selbst (Software) oder die Grafikkarte (OpenGL)</translation>
    </message>
    <message>
        <source>%1 simulations/s</source>
        <translation>%1 Simulationen/s</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibungszahl</translation>
    </message>
    <message>
        <source>this line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>force F̄ = %1</source>
        <translation>Kraft F̄ = %1</translation>
    </message>
    <message>
        <source>F̄ = %1</source>
        <translation>F̄ = %1</translation>
    </message>
    <message>
        <source>v̄ = %1</source>
        <translation>v̄ = %1</translation>
    </message>
    <message>
        <source>This window has no room for: %1.</source>
        <translation>In diesem Fenster ist kein Platz für: %1.</translation>
    </message>
    <message>
        <source>velocity v̄ = %1</source>
        <translation>Geschw. v̄ = %1</translation>
    </message>
    <message>
        <source>1 frame/s</source>
        <translation>1 Bild/s</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>⚠ 1 note</source>
        <translation>⚠ 1 Hinweis</translation>
    </message>
    <message>
        <source>⚠ %1 notes</source>
        <translation>⚠ %1 Hinweise</translation>
    </message>
    <message>
        <source>notes on how far the results hold</source>
        <translation>Hinweise, wie weit die Ergebnisse gelten</translation>
    </message>
    <message>
        <source>deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>this line, deformation</source>
        <translation>diese Linie, Verformung</translation>
    </message>
    <message>
        <source>settling</source>
        <translation>schwingt ein</translation>
    </message>
</context>
<context>
    <name>asperity::SurfaceImport</name>
    <message>
        <source>what is known of the surface</source>
        <translation>was von der Oberfläche bekannt ist</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>roh</translation>
    </message>
    <message>
        <source>used</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>&amp;Use this surface</source>
        <translation>Diese Oberfläche &amp;verwenden</translation>
    </message>
    <message>
        <source>Open surface</source>
        <translation>Oberfläche öffnen</translation>
    </message>
    <message>
        <source>the profile, raw and used</source>
        <translation>das Profil, roh und verwendet</translation>
    </message>
    <message>
        <source>spectrum and distribution of the heights, raw and used</source>
        <translation>Spektrum und Verteilung der Höhen, roh und verwendet</translation>
    </message>
    <message>
        <source>The file</source>
        <translation>Die Datei</translation>
    </message>
    <message>
        <source>Levelling and filters</source>
        <translation>Ausrichten und Filtern</translation>
    </message>
    <message>
        <source>The line that slides</source>
        <translation>Die gleitende Linie</translation>
    </message>
    <message>
        <source>Normal force %1 on one period of %2, that is %3.</source>
        <translation>Normalkraft %1 auf eine Periode von %2, das sind %3.</translation>
    </message>
</context>
<context>
    <name>asperity::TimeBar</name>
    <message>
        <source>moment of the motion</source>
        <translation>Zeitpunkt der Bewegung</translation>
    </message>
    <message>
        <source>Drag it to any other moment of the motion.</source>
        <translation>Zu jedem anderen Zeitpunkt der Bewegung ziehen.</translation>
    </message>
    <message>
        <source>constant pace</source>
        <translation>gleiches Tempo</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>pace</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1× slower</source>
        <translation>%1× langsamer</translation>
    </message>
    <message>
        <source>%1× faster</source>
        <translation>%1× schneller</translation>
    </message>
    <message>
        <source>pace of the picture</source>
        <translation>Tempo des Bildes</translation>
    </message>
    <message>
        <source>How many times slower or faster than in reality the picture moves; to the right faster. A number alone, such as 600, means slower.</source>
        <translation>Um welchen Faktor sich das Bild langsamer oder schneller bewegt als die Wirklichkeit; nach rechts schneller. Eine Zahl allein, etwa 600, heißt langsamer.</translation>
    </message>
    <message>
        <source>pace of the picture, times slower or faster than in reality</source>
        <translation>Tempo des Bildes, wievielmal langsamer oder schneller als in Wirklichkeit</translation>
    </message>
    <message>
        <source>The picture moves as fast as before when the velocity changes. Without it a faster line also looks faster.</source>
        <translation>Das Bild bewegt sich so schnell wie zuvor, wenn sich die Geschwindigkeit ändert. Ohne dies sieht eine schnellere Linie auch schneller aus.</translation>
    </message>
    <message>
        <source>the computer cannot keep up</source>
        <translation>der Rechner kommt nicht nach</translation>
    </message>
    <message>
        <source>The line has too many elements to move as fast as requested. The number is the pace that the picture has.</source>
        <translation>Die Linie hat zu viele Elemente, um sich so schnell wie gewünscht zu bewegen. Die Zahl ist das Tempo, das das Bild hat.</translation>
    </message>
    <message>
        <source>“%1” is beyond what the picture can show, %2 to %3; %4 is chosen</source>
        <translation>„%1“ kann das Bild nicht zeigen, nur %2 bis %3; gewählt ist %4</translation>
    </message>
    <message>
        <source>“%1” is not a pace; enter 600, 600× slower or 20× faster</source>
        <translation>„%1“ ist kein Tempo; möglich sind 600, 600× langsamer oder 20× schneller</translation>
    </message>
</context>
<context>
    <name>asperity::TitleBar</name>
    <message>
        <source>Back to the contact (Esc)</source>
        <translation>Zurück zum Kontakt (Esc)</translation>
    </message>
    <message>
        <source>back to the contact</source>
        <translation>zurück zum Kontakt</translation>
    </message>
</context>
<context>
    <name>asperity::TopographyPicture</name>
    <message>
        <source>topography</source>
        <translation>Topographie</translation>
    </message>
    <message>
        <source>%1 × %2, heights over %3</source>
        <translation>%1 × %2, Höhen über %3</translation>
    </message>
</context>
<context>
    <name>asperity::Tour</name>
    <message>
        <source>Press</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>A rough line rests on rubber: only its highest summits touch.</source>
        <translation>Eine raue Linie ruht auf Gummi: Nur ihre höchsten Gipfel berühren es.</translation>
    </message>
    <message>
        <source>Raise the normal force: contacts grow in number and length.</source>
        <translation>Die Normalkraft erhöhen: Die Kontakte wachsen an Zahl und Länge.</translation>
    </message>
    <message>
        <source>Slide slowly</source>
        <translation>Langsam gleiten</translation>
    </message>
    <message>
        <source>The rubber has time to come back behind every summit, and friction grows in proportion to the velocity.</source>
        <translation>Das Gummi hat Zeit, hinter jedem Gipfel zurückzukehren, und die Reibung wächst proportional zur Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Double the velocity: the coefficient of friction doubles.</source>
        <translation>Die Geschwindigkeit verdoppeln: Die Reibungszahl verdoppelt sich.</translation>
    </message>
    <message>
        <source>The plateau</source>
        <translation>Das Plateau</translation>
    </message>
    <message>
        <source>At higher velocity friction stops growing: it is now set by the slope of the line, not by the rubber.</source>
        <translation>Bei höherer Geschwindigkeit wächst die Reibung nicht mehr: Sie wird nun von der Steigung der Linie bestimmt, nicht vom Gummi.</translation>
    </message>
    <message>
        <source>Change the shear modulus or the force: the height of the plateau stays, but its place on the axis moves.</source>
        <translation>Schubmodul oder Kraft ändern: Die Höhe des Plateaus bleibt, aber seine Stelle auf der Achse verschiebt sich.</translation>
    </message>
    <message>
        <source>One-sided contact</source>
        <translation>Einseitiger Kontakt</translation>
    </message>
    <message>
        <source>A single summit shows why: the rubber is too slow to touch its trailing side, so it pushes only from the front.</source>
        <translation>Ein einzelner Gipfel zeigt, warum: Das Gummi ist zu langsam, um dessen Rückseite zu berühren, und drückt daher nur von vorn.</translation>
    </message>
    <message>
        <source>Lower the velocity to 0.001 m/s: contact becomes even on both sides, and friction vanishes.</source>
        <translation>Die Geschwindigkeit auf 0,001 m/s senken: Der Kontakt wird auf beiden Seiten gleich, und die Reibung verschwindet.</translation>
    </message>
    <message>
        <source>Region IV</source>
        <translation>Bereich IV</translation>
    </message>
    <message>
        <source>Faster still, only the tips of the highest summits touch, and they are smooth: friction falls again.</source>
        <translation>Noch schneller: Nur die Kuppen der höchsten Gipfel haben Kontakt, und sie sind glatt. Die Reibung fällt wieder.</translation>
    </message>
    <message>
        <source>Complete contact</source>
        <translation>Vollkontakt</translation>
    </message>
    <message>
        <source>Under a high load the rubber fills every valley, and friction is known exactly.</source>
        <translation>Unter hoher Last füllt das Gummi jedes Tal, und die Reibung ist exakt bekannt.</translation>
    </message>
    <message>
        <source>Raise the velocity until the first valleys open: there the straight line ends.</source>
        <translation>Die Geschwindigkeit erhöhen, bis sich die ersten Täler öffnen: Dort endet die Gerade.</translation>
    </message>
    <message>
        <source>Guided tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Tour: back</source>
        <translation>Rundgang: zurück</translation>
    </message>
    <message>
        <source>Tour: next</source>
        <translation>Rundgang: weiter</translation>
    </message>
    <message>
        <source>New here? A tour of six steps shows what there is to see. Lessons are under Help.</source>
        <translation>Neu hier? Ein Rundgang in sechs Schritten zeigt, was es zu sehen gibt. Lektionen stehen unter Hilfe.</translation>
    </message>
    <message>
        <source>Take the tour</source>
        <translation>Rundgang beginnen</translation>
    </message>
    <message>
        <source>Raise the number of elements: finer tips move the fall to higher velocities.</source>
        <translation>Die Zahl der Elemente erhöhen: Feinere Kuppen verschieben den Abfall zu höheren Geschwindigkeiten.</translation>
    </message>
</context>
<context>
    <name>asperity::TourBar</name>
    <message>
        <source>%1 of %2&amp;ensp;&lt;b&gt;%3.&lt;/b&gt; %4 &lt;i&gt;Try: %5&lt;/i&gt;</source>
        <translation>%1 von %2&amp;ensp;&lt;b&gt;%3.&lt;/b&gt; %4 &lt;i&gt;Versuch: %5&lt;/i&gt;</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Beenden</translation>
    </message>
</context>
<context>
    <name>asperity::ViewActionText</name>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>At the crosshair or in the middle; also with the wheel</source>
        <translation>Am Fadenkreuz oder in der Mitte; auch mit dem Mausrad</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Also with the wheel</source>
        <translation>Auch mit dem Mausrad</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>The whole period, heights fitted; also a double click</source>
        <translation>Die ganze Periode, Höhen eingepasst; auch mit Doppelklick</translation>
    </message>
    <message>
        <source>More vertical exaggeration</source>
        <translation>Stärker überhöhen</translation>
    </message>
    <message>
        <source>Also with Ctrl and the wheel</source>
        <translation>Auch mit Strg und Mausrad</translation>
    </message>
    <message>
        <source>Less vertical exaggeration</source>
        <translation>Schwächer überhöhen</translation>
    </message>
    <message>
        <source>Fit heights</source>
        <translation>Höhen einpassen</translation>
    </message>
    <message>
        <source>The exaggeration that shows all heights</source>
        <translation>Die Überhöhung, die alle Höhen zeigt</translation>
    </message>
    <message>
        <source>Follow the line</source>
        <translation>Der Linie folgen</translation>
    </message>
    <message>
        <source>The line stands still in the picture and the elastomer passes by</source>
        <translation>Die Linie steht im Bild still, und das Elastomer zieht vorbei</translation>
    </message>
    <message>
        <source>Magnifier</source>
        <translation>Lupe</translation>
    </message>
    <message>
        <source>Enlarges the asperity at the crosshair, or the one under the greatest line load</source>
        <translation>Vergrößert die Rauheitsspitze am Fadenkreuz oder die unter der größten Linienlast</translation>
    </message>
    <message>
        <source>Line load</source>
        <translation>Linienlast</translation>
    </message>
    <message>
        <source>Where the bodies press on each other, and how much: force per length of the line</source>
        <translation>Wo die Körper aufeinander drücken und wie stark: Kraft je Länge der Linie</translation>
    </message>
    <message>
        <source>Time since contact</source>
        <translation>Zeit seit dem Kontakt</translation>
    </message>
    <message>
        <source>How long the free surface has had to recover</source>
        <translation>Wie lange die freie Oberfläche zur Rückkehr hatte</translation>
    </message>
    <message>
        <source>Dissipated power</source>
        <translation>Dissipierte Leistung</translation>
    </message>
    <message>
        <source>Where friction turns into heat: in contact and where the surface recovers</source>
        <translation>Wo Reibung zu Wärme wird: im Kontakt und wo die Oberfläche zurückkehrt</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Colour by</source>
        <translation>Färben nach</translation>
    </message>
    <message>
        <source>Next colouring</source>
        <translation>Nächste Färbung</translation>
    </message>
    <message>
        <source>Switches to the next colouring</source>
        <translation>Wechselt zur nächsten Färbung</translation>
    </message>
    <message>
        <source>Press harder</source>
        <translation>Stärker drücken</translation>
    </message>
    <message>
        <source>More load; also by dragging the rigid body or the force&apos;s arrow down</source>
        <translation>Mehr Last; auch durch Ziehen des starren Körpers oder des Kraftpfeils nach unten</translation>
    </message>
    <message>
        <source>Press less</source>
        <translation>Schwächer drücken</translation>
    </message>
    <message>
        <source>Less load; also by dragging the rigid body or the force&apos;s arrow up</source>
        <translation>Weniger Last; auch durch Ziehen des starren Körpers oder des Kraftpfeils nach oben</translation>
    </message>
    <message>
        <source>Slide faster</source>
        <translation>Schneller gleiten</translation>
    </message>
    <message>
        <source>More velocity; also by dragging its arrow to the right</source>
        <translation>Mehr Geschwindigkeit; auch durch Ziehen ihres Pfeils nach rechts</translation>
    </message>
    <message>
        <source>Slide slower</source>
        <translation>Langsamer gleiten</translation>
    </message>
    <message>
        <source>Less velocity; also by dragging its arrow to the left</source>
        <translation>Weniger Geschwindigkeit; auch durch Ziehen ihres Pfeils nach links</translation>
    </message>
    <message>
        <source>Read about it in the guide</source>
        <translation>Im Handbuch nachlesen</translation>
    </message>
    <message>
        <source>Opens the guide at what is under the pointer: a reading, a label, the colours</source>
        <translation>Öffnet das Handbuch bei dem, was unter dem Zeiger ist: Messwert, Beschriftung, Farben</translation>
    </message>
    <message>
        <source>Zoom and exaggeration</source>
        <translation>Vergrößern und überhöhen</translation>
    </message>
    <message>
        <source>Press and slide</source>
        <translation>Drücken und gleiten</translation>
    </message>
</context>
<context>
    <name>asperity::WindowLayout</name>
    <message>
        <source>Full screen</source>
        <translation>Vollbild</translation>
    </message>
    <message>
        <source>Presentation</source>
        <translation>Präsentation</translation>
    </message>
    <message>
        <source>Leave full screen</source>
        <translation>Vollbild verlassen</translation>
    </message>
    <message>
        <source>Restore layout</source>
        <translation>Anordnung wiederherstellen</translation>
    </message>
    <message>
        <source>More height for the contact</source>
        <translation>Mehr Höhe für den Kontakt</translation>
    </message>
    <message>
        <source>More height for the chart</source>
        <translation>Mehr Höhe für das Diagramm</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>F9 shows the parameters; Esc ends the presentation.</source>
        <translation>F9 zeigt die Parameter; Esc beendet die Präsentation.</translation>
    </message>
</context>
<context>
    <name>asperity::Words</name>
    <message>
        <source>some simulations failed: &apos;asperity study show&apos; says why</source>
        <translation>einige Simulationen sind gescheitert: &apos;asperity study show&apos; sagt, warum</translation>
    </message>
    <message>
        <source>The force that sliding takes. It is a result and cannot be dragged.</source>
        <translation>Die Kraft, die das Gleiten erfordert. Sie ist ein Ergebnis und lässt sich nicht ziehen.</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>μ of the interface</source>
        <translation>μ der Grenzfläche</translation>
    </message>
    <message>
        <source>Of local friction in contact, beside what the deformation costs; it does not change the contact.</source>
        <translation>Aus lokaler Reibung im Kontakt, neben dem, was die Verformung kostet; sie ändert den Kontakt nicht.</translation>
    </message>
    <message>
        <source>μ in total</source>
        <translation>μ gesamt</translation>
    </message>
    <message>
        <source>Of deformation and interface together: friction force over normal force.</source>
        <translation>Aus Verformung und Grenzfläche zusammen: Reibungskraft durch Normalkraft.</translation>
    </message>
    <message>
        <source>μ of the deformation</source>
        <translation>μ der Verformung</translation>
    </message>
    <message>
        <source>coefficient of friction μ</source>
        <translation>Reibungszahl μ</translation>
    </message>
    <message>
        <source>μ when settled</source>
        <translation>μ stationär</translation>
    </message>
    <message>
        <source>Friction in the steady state, as in the chart. The picture is still approaching it.</source>
        <translation>Reibung im stationären Zustand, wie im Diagramm. Das Bild nähert sich ihm noch.</translation>
    </message>
    <message>
        <source>normal force F</source>
        <translation>Normalkraft F</translation>
    </message>
    <message>
        <source>Force that presses one period of the line into the elastomer.</source>
        <translation>Kraft, die eine Periode der Linie in das Elastomer drückt.</translation>
    </message>
    <message>
        <source>indentation d</source>
        <translation>Eindringung d</translation>
    </message>
    <message>
        <source>How deep the lowest point of the line lies below the undeformed surface.</source>
        <translation>Wie tief der tiefste Punkt der Linie unter der unverformten Oberfläche liegt.</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>in Kontakt</translation>
    </message>
    <message>
        <source>Share of the line&apos;s length that touches the elastomer.</source>
        <translation>Anteil der Länge der Linie, der das Elastomer berührt.</translation>
    </message>
    <message>
        <source>velocity v</source>
        <translation>Geschwindigkeit v</translation>
    </message>
    <message>
        <source>Velocity of the line, to the right.</source>
        <translation>Geschwindigkeit der Linie, nach rechts.</translation>
    </message>
    <message>
        <source>Velocity of the line at this moment; below 0 it goes back.</source>
        <translation>Geschwindigkeit der Linie in diesem Augenblick; unter 0 geht sie zurück.</translation>
    </message>
    <message>
        <source>One second on the screen shows %1 of the motion.</source>
        <translation>Eine Sekunde im Bild zeigt %1 der Bewegung.</translation>
    </message>
    <message>
        <source>rigid line at rest</source>
        <translation>starre Linie in Ruhe</translation>
    </message>
    <message>
        <source>slides</source>
        <translation>gleitet</translation>
    </message>
    <message>
        <source>rigid line slides</source>
        <translation>starre Linie gleitet</translation>
    </message>
    <message>
        <source>elastomer</source>
        <translation>Elastomer</translation>
    </message>
    <message>
        <source>rigid body</source>
        <translation>starrer Körper</translation>
    </message>
    <message>
        <source>dot: the greatest line load</source>
        <translation>Punkt: die größte Linienlast</translation>
    </message>
    <message>
        <source>dot: a contact too small to be drawn</source>
        <translation>Punkt: ein Kontakt, zu klein zum Zeichnen</translation>
    </message>
    <message>
        <source>glow: line load, not depth</source>
        <translation>Leuchten: Linienlast, nicht Tiefe</translation>
    </message>
    <message>
        <source>below: the elastomer</source>
        <translation>unten: das Elastomer</translation>
    </message>
    <message>
        <source>elastomer: %1</source>
        <translation>Elastomer: %1</translation>
    </message>
    <message>
        <source>time since contact</source>
        <translation>Zeit seit dem Kontakt</translation>
    </message>
    <message>
        <source>dissipated power, log scale</source>
        <translation>dissipierte Leistung, log. Skala</translation>
    </message>
    <message>
        <source>since contact</source>
        <translation>seit Kontakt</translation>
    </message>
    <message>
        <source>power, log</source>
        <translation>Leistung, log</translation>
    </message>
    <message>
        <source>line load</source>
        <translation>Linienlast</translation>
    </message>
    <message>
        <source>position x</source>
        <translation>Ort x</translation>
    </message>
    <message>
        <source>rigid line z − d</source>
        <translation>starre Linie z − d</translation>
    </message>
    <message>
        <source>elastomer u</source>
        <translation>Elastomer u</translation>
    </message>
    <message>
        <source>line load p</source>
        <translation>Linienlast p</translation>
    </message>
    <message>
        <source>gap</source>
        <translation>Spalt</translation>
    </message>
    <message>
        <source>slope z′</source>
        <translation>Steigung z′</translation>
    </message>
    <message>
        <source>rate du/dt</source>
        <translation>Rate du/dt</translation>
    </message>
    <message>
        <source>free for</source>
        <translation>frei seit</translation>
    </message>
    <message>
        <source>dissipates</source>
        <translation>dissipiert</translation>
    </message>
    <message>
        <source>only for scheme %1</source>
        <translation>nur für das Verfahren %1</translation>
    </message>
    <message>
        <source>undecided</source>
        <translation>unentschieden</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 fehlgeschlagen</translation>
    </message>
    <message>
        <source>not of this run: %1, left by an earlier one</source>
        <translation>nicht von diesem Lauf: %1, von einem früheren geblieben</translation>
    </message>
    <message>
        <source>one scene, %1 failed</source>
        <translation>eine Szene, davon %1 fehlgeschlagen</translation>
    </message>
    <message>
        <source>%1 scenes, %2 failed</source>
        <translation>%1 Szenen, davon %2 fehlgeschlagen</translation>
    </message>
    <message>
        <source>target accuracy missed: %1</source>
        <translation>Zielgenauigkeit verfehlt: %1</translation>
    </message>
    <message>
        <source>figure %1</source>
        <translation>Abbildung %1</translation>
    </message>
    <message>
        <source>time steps</source>
        <translation>Zeitschritte</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>realizations</source>
        <translation>Realisierungen</translation>
    </message>
    <message>
        <source>parts of the surface</source>
        <translation>Teile der Oberfläche</translation>
    </message>
    <message>
        <source>lines compared</source>
        <translation>verglichene Linien</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>evaluations</source>
        <translation>Auswertungen</translation>
    </message>
    <message>
        <source>states</source>
        <translation>Zustände</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>simulations</source>
        <translation>Simulationen</translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>%1 simulations</source>
        <translation>%1 Simulationen</translation>
    </message>
    <message>
        <source>shard %1 of %2</source>
        <translation>Teil %1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 simulations done</source>
        <translation>%1 von %2 Simulationen fertig</translation>
    </message>
    <message>
        <source>%1 simulations a second on one thread</source>
        <translation>%1 Simulationen in der Sekunde auf einem Thread</translation>
    </message>
    <message>
        <source>the rest takes about %1 of one thread</source>
        <translation>der Rest braucht etwa %1 auf einem Thread</translation>
    </message>
    <message>
        <source>%1 simulations failed:</source>
        <translation>%1 Simulationen sind gescheitert:</translation>
    </message>
    <message>
        <source>  %1 times, first %2: %3</source>
        <translation>  %1 Mal, zuerst %2: %3</translation>
    </message>
    <message>
        <source>%1 of %2 simulations</source>
        <translation>%1 von %2 Simulationen</translation>
    </message>
    <message>
        <source>%1, %2: first order %3, total %4</source>
        <translation>%1, %2: erste Ordnung %3, gesamt %4</translation>
    </message>
    <message>
        <source>%1: %2 simulations without a number are left out</source>
        <translation>%1: %2 Simulationen ohne Zahl sind weggelassen</translation>
    </message>
    <message>
        <source>no Sobol indices: they need sampling saltelli</source>
        <translation>keine Sobol-Indizes: sie verlangen sampling saltelli</translation>
    </message>
    <message>
        <source>Goal</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>%1 minutes</source>
        <translation>%1 Minuten</translation>
    </message>
    <message>
        <source>Notes for the teacher</source>
        <translation>Hinweise für Lehrende</translation>
    </message>
    <message>
        <source>the contact of the rough line and the rubber</source>
        <translation>der Kontakt der rauen Linie mit dem Gummi</translation>
    </message>
    <message>
        <source>an empty chart of friction, to draw into</source>
        <translation>ein leeres Diagramm der Reibung, zum Hineinzeichnen</translation>
    </message>
    <message>
        <source>the friction curve</source>
        <translation>die Reibungskurve</translation>
    </message>
    <message>
        <source>My answer</source>
        <translation>Meine Antwort</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>%1 minutes, %2 steps, %3 predictions</source>
        <translation>%1 Minuten, %2 Schritte, %3 Vorhersagen</translation>
    </message>
    <message>
        <source>%1: run times, and what follows from them, are measured again; all other numbers are the same</source>
        <translation>%1: Laufzeiten, und was aus ihnen folgt, sind neu gemessen; alle anderen Zahlen sind dieselben</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Eq. (%1)</source>
        <translation>Gl. (%1)</translation>
    </message>
    <message>
        <source>slow motion</source>
        <translation>Zeitlupe</translation>
    </message>
    <message>
        <source>time lapse</source>
        <translation>Zeitraffer</translation>
    </message>
    <message>
        <source>the spectrum of the line</source>
        <translation>das Spektrum der Linie</translation>
    </message>
    <message>
        <source>the statistics of the line</source>
        <translation>die Statistik der Linie</translation>
    </message>
    <message>
        <source>the moduli of the elastomer</source>
        <translation>die Moduln des Elastomers</translation>
    </message>
    <message>
        <source>Mark the place in the chart.</source>
        <translation>Zeichne die Stelle im Diagramm ein.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>After the answer to step %1</source>
        <translation>Nach der Antwort zu Schritt %1</translation>
    </message>
    <message>
        <source>Turn the page when you have answered.</source>
        <translation>Blättere erst um, wenn du geantwortet hast.</translation>
    </message>
    <message>
        <source>a factor of %1</source>
        <translation>einem Faktor %1</translation>
    </message>
    <message>
        <source>%1, its place within %2</source>
        <translation>%1, die Stelle innerhalb von %2</translation>
    </message>
    <message>
        <source>right within %1</source>
        <translation>richtig innerhalb von %1</translation>
    </message>
    <message>
        <source>A height within a factor of %1 counts as right.</source>
        <translation>Richtig ist eine Höhe, die höchstens um den Faktor %1 abweicht.</translation>
    </message>
    <message>
        <source>A height within a factor of %1 and a place within a factor of %2 count as right.</source>
        <translation>Richtig ist ein Punkt, dessen Höhe höchstens um den Faktor %1 und dessen Stelle höchstens um den Faktor %2 abweicht.</translation>
    </message>
    <message>
        <source>The height is right, the place is not.</source>
        <translation>Die Höhe stimmt, die Stelle nicht.</translation>
    </message>
    <message>
        <source>The place is right, the height is not.</source>
        <translation>Die Stelle stimmt, die Höhe nicht.</translation>
    </message>
    <message>
        <source>Neither the place nor the height is right.</source>
        <translation>Weder die Stelle noch die Höhe stimmt.</translation>
    </message>
    <message>
        <source>The program finds %1.</source>
        <translation>Das Programm findet %1.</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Nein</translation>
    </message>
    <message>
        <source>You said %1.</source>
        <translation>Deine Antwort war %1.</translation>
    </message>
    <message>
        <source>An answer within %1 of the right one counts.</source>
        <translation>Es zählt, was höchstens %1 abweicht.</translation>
    </message>
    <message>
        <source>An answer from %1 to %2 times the right one counts.</source>
        <translation>Es zählt das %1- bis %2-Fache des richtigen Werts.</translation>
    </message>
    <message>
        <source>a chart of friction, to draw into, with the curve for %1</source>
        <translation>ein Diagramm der Reibung zum Hineinzeichnen, mit der Kurve für %1</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>choice %1</source>
        <translation>Antwort %1</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Right answer</source>
        <translation>Richtige Antwort</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
</context>
<context>
    <name>asperity::WorkIndicator</name>
    <message>
        <source>making the line</source>
        <translation>die Linie entsteht</translation>
    </message>
    <message>
        <source>progress of the curve</source>
        <translation>Fortschritt der Kurve</translation>
    </message>
    <message>
        <source>Making the line… Back to the previous scene</source>
        <translation>Die Linie entsteht… Zurück zur vorigen Szene</translation>
    </message>
    <message>
        <source>The curve is not complete: average it again</source>
        <translation>Die Kurve ist nicht vollständig: erneut mitteln</translation>
    </message>
    <message>
        <source>Stop averaging the curve</source>
        <translation>Mittelung der Kurve anhalten</translation>
    </message>
</context>
</TS>
