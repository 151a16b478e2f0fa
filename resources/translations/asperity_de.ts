<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<context>
    <name>Words</name>
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
        <source>viscoelastic, G = %1, %2 arm</source>
        <translation>viskoelastisch, G = %1, %2 Arm</translation>
    </message>
    <message>
        <source>viscoelastic, G = %1, %2 arms</source>
        <translation>viskoelastisch, G = %1, %2 Arme</translation>
    </message>
    <message>
        <source>vertical exaggeration %1×</source>
        <translation>%1-fach überhöht</translation>
    </message>
    <message>
        <source>coefficient of friction</source>
        <translation>Reibungszahl</translation>
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
        <source>all results as a table</source>
        <translation>alle Ergebnisse als Tabelle</translation>
    </message>
    <message>
        <source>Made by Asperity %1.</source>
        <translation>Erstellt mit Asperity %1.</translation>
    </message>
    <message>
        <source>contact pressure (line load)</source>
        <translation>Kontaktdruck (Linienlast)</translation>
    </message>
</context>
<context>
    <name>asperity::AccuracyPanel</name>
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
        <source>Scheme, oversampling and realizations as the parameters say</source>
        <translation>Verfahren, Überabtastung und Realisierungen nach den Parametern</translation>
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
        <source>“Compare methods” measures what accuracy costs for this scene.</source>
        <translation>„Verfahren vergleichen“ misst, was Genauigkeit bei dieser Szene kostet.</translation>
    </message>
    <message>
        <source>target: %1 of μ at every velocity</source>
        <translation>Ziel: %1 von μ bei jeder Geschwindigkeit</translation>
    </message>
    <message>
        <source>no target: as scheme and realizations say</source>
        <translation>kein Ziel: nach Verfahren und Realisierungen</translation>
    </message>
    <message>
        <source>measured: %1, standard error %2</source>
        <translation>gemessen: %1, Standardfehler %2</translation>
    </message>
    <message>
        <source>predicting …</source>
        <translation>Vorhersage läuft …</translation>
    </message>
    <message>
        <source>predicted: %1, error %2 (resolution %3, realizations %4)</source>
        <translation>vorhergesagt: %1, Fehler %2 (Auflösung %3, Realisierungen %4)</translation>
    </message>
    <message>
        <source>Cancel (%1 %)</source>
        <translation>Abbrechen (%1 %)</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>measuring every method on this scene&apos;s lines …</source>
        <translation>Jedes Verfahren wird auf den Linien dieser Szene gemessen …</translation>
    </message>
</context>
<context>
    <name>asperity::ClaimsTable</name>
    <message>
        <source>only for scheme %1</source>
        <translation>nur für %1</translation>
    </message>
    <message>
        <source>✓ yes</source>
        <translation>✓ ja</translation>
    </message>
    <message>
        <source>✗ no</source>
        <translation>✗ nein</translation>
    </message>
    <message>
        <source>Measured: %1.</source>
        <translation>Gemessen: %1.</translation>
    </message>
    <message>
        <source>Holds when: %1.</source>
        <translation>Gilt, wenn: %1.</translation>
    </message>
    <message>
        <source>what the paper says of this figure, and whether it holds</source>
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
        <source>Measured</source>
        <translation>Gemessen</translation>
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
        <source>software (OSMesa)</source>
        <translation>Software (OSMesa)</translation>
    </message>
</context>
<context>
    <name>asperity::FigureGallery</name>
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
    <name>asperity::FrictionPlot</name>
    <message>
        <source>v = %1 m/s</source>
        <translation>v = %1 m/s</translation>
    </message>
    <message>
        <source>sliding velocity v (m/s)</source>
        <translation>Gleitgeschwindigkeit v (m/s)</translation>
    </message>
    <message>
        <source>coefficient of friction μ</source>
        <translation>Reibungszahl μ</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>this line, now</source>
        <translation>diese Linie, jetzt</translation>
    </message>
    <message>
        <source>this line</source>
        <translation>diese Linie</translation>
    </message>
    <message>
        <source>mean of the lines ± standard error</source>
        <translation>Mittel über die Linien ± Standardfehler</translation>
    </message>
    <message>
        <source>Eq. (11)</source>
        <translation>Gl. (11)</translation>
    </message>
    <message>
        <source>no curve yet</source>
        <translation>noch keine Kurve</translation>
    </message>
    <message>
        <source>curve of the scene before</source>
        <translation>Kurve der vorigen Szene</translation>
    </message>
    <message>
        <source>%1 of %2 realizations</source>
        <translation>%1 von %2 Realisierungen</translation>
    </message>
    <message>
        <source>no friction: nothing positive to show on a logarithmic axis</source>
        <translation>keine Reibung: nichts Positives für eine logarithmische Achse</translation>
    </message>
    <message>
        <source>no positive coefficient of friction to show on a logarithmic axis</source>
        <translation>keine positive Reibungszahl für eine logarithmische Achse</translation>
    </message>
</context>
<context>
    <name>asperity::GalleryPage</name>
    <message>
        <source>Figures of the paper, computed here and now</source>
        <translation>Abbildungen der Arbeit, hier und jetzt berechnet</translation>
    </message>
    <message>
        <source>✕</source>
        <translation>✕</translation>
    </message>
    <message>
        <source>Back to the contact (Esc)</source>
        <translation>Zurück zum Kontakt (Esc)</translation>
    </message>
    <message>
        <source>back to the contact</source>
        <translation>zurück zum Kontakt</translation>
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
        <translation>Arb&amp;eit</translation>
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
        <source>This figure, from lines made anew (Enter in the list)</source>
        <translation>Diese Abbildung aus neu erzeugten Linien (Eingabetaste in der Liste)</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Abb&amp;rechen</translation>
    </message>
    <message>
        <source>Ends what is computed and what waits</source>
        <translation>Beendet die laufende und alle wartenden Berechnungen</translation>
    </message>
    <message>
        <source>progress of the computation</source>
        <translation>Fortschritt der Berechnung</translation>
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
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Bilder (*.png *.svg *.pdf)</translation>
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
        <source>Saving %1…</source>
        <translation>%1 wird gespeichert…</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
</context>
<context>
    <name>asperity::MainWindow</name>
    <message>
        <source>close</source>
        <translation>schließen</translation>
    </message>
    <message>
        <source>coefficient of friction against velocity</source>
        <translation>Reibungszahl über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Asperity</source>
        <translation>Asperity</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Schritt</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Zurücksetzen</translation>
    </message>
    <message>
        <source>Open scene…</source>
        <translation>Szene öffnen…</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Szenen</translation>
    </message>
    <message>
        <source>Fi&amp;gures</source>
        <translation>Ab&amp;bildungen</translation>
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
        <source>About Asperity</source>
        <translation>Über Asperity</translation>
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
        <source>Play</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
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
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>All figures</source>
        <translation>Alle Abbildungen</translation>
    </message>
    <message>
        <source>Figures</source>
        <translation>Abbildungen</translation>
    </message>
    <message>
        <source>Open scene</source>
        <translation>Szene öffnen</translation>
    </message>
    <message>
        <source>Scenes (*.json);;Pictures and tables (*.png *.svg *.pdf *.csv *.mp4 *.webm *.gif *.webp)</source>
        <translation>Szenen (*.json);;Bilder und Tabellen (*.png *.svg *.pdf *.csv *.mp4 *.webm *.gif *.webp)</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Scenes (*.json)</source>
        <translation>Szenen (*.json)</translation>
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
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>The language changes when Asperity is started again.</source>
        <translation>Die Sprache wechselt beim nächsten Start von Asperity.</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Bild kopieren</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Bild speichern…</translation>
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
        <source>Save picture</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Bilder (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation>%1 gespeichert</translation>
    </message>
    <message>
        <source>On the clipboard: %1</source>
        <translation>In der Zwischenablage: %1</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Back to the scene as opened</source>
        <translation>Zurück zur Szene wie geöffnet</translation>
    </message>
    <message>
        <source>All parameters to their defaults</source>
        <translation>Alle Parameter auf ihre Vorgaben</translation>
    </message>
    <message>
        <source>Undo %1</source>
        <translation>%1 rückgängig machen</translation>
    </message>
    <message>
        <source>Redo %1</source>
        <translation>%1 wiederherstellen</translation>
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
        <source>All parameters</source>
        <translation>Alle Parameter</translation>
    </message>
    <message>
        <source>The scene was changed. Save the changes?</source>
        <translation>Die Szene wurde geändert. Änderungen speichern?</translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation>Sonst gehen sie verloren.</translation>
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
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Clear this list</source>
        <translation>Liste leeren</translation>
    </message>
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
        <source>Tabs</source>
        <translation>Reiter</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
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
    <name>asperity::MessageBar</name>
    <message>
        <source>close message</source>
        <translation>Meldung schließen</translation>
    </message>
</context>
<context>
    <name>asperity::ParameterPanel</name>
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
        <source>Friction curve</source>
        <translation>Reibungskurve</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Choose a profile</source>
        <translation>Profil wählen</translation>
    </message>
    <message>
        <source>Profiles (*.csv);;All files (*)</source>
        <translation>Profile (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>as in file</source>
        <translation>wie Datei</translation>
    </message>
    <message>
        <source>choose a profile file</source>
        <translation>Profildatei wählen</translation>
    </message>
    <message>
        <source>Interface</source>
        <translation>Grenzfläche</translation>
    </message>
</context>
<context>
    <name>asperity::ParameterRow</name>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>choose file…</source>
        <translation>Datei wählen…</translation>
    </message>
    <message>
        <source>Back to the default, %1</source>
        <translation>Zurück zur Vorgabe, %1</translation>
    </message>
    <message>
        <source>As the file says</source>
        <translation>Wie in der Datei</translation>
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
        <source>A number alone counts in the unit beside it, one with an exponent (1e7) in %1; any unit may be typed with it.</source>
        <translation>Eine Zahl allein gilt in der Einheit daneben, eine mit Exponent (1e7) in %1; jede Einheit darf dazu getippt werden.</translation>
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
    <name>asperity::SceneDocument</name>
    <message>
        <source>%1 parameters</source>
        <translation>%1 Parameter</translation>
    </message>
</context>
<context>
    <name>asperity::Session</name>
    <message>
        <source>The numbers of this scene leave what a computer can hold.</source>
        <translation>Die Zahlen dieser Szene übersteigen, was ein Rechner fassen kann.</translation>
    </message>
    <message>
        <source>No steady sliding was found at this load and velocity.</source>
        <translation>Bei dieser Last und Geschwindigkeit wurde kein stationäres Gleiten gefunden.</translation>
    </message>
</context>
<context>
    <name>asperity::StatusLine</name>
    <message>
        <source>Coefficient of friction of this line in steady sliding</source>
        <translation>Reibungszahl dieser Linie beim stationären Gleiten</translation>
    </message>
    <message>
        <source>Eq. (14) of the paper: normal force / (shear modulus × rms height × length)</source>
        <translation>Gl. (14) der Arbeit: Normalkraft / (Schubmodul × RMS-Höhe × Länge)</translation>
    </message>
    <message>
        <source>Eq. (13) of the paper: relaxation time × velocity × rms slope / (√2 × rms height)</source>
        <translation>Gl. (13) der Arbeit: Relaxationszeit × Geschwindigkeit × RMS-Steigung / (√2 × RMS-Höhe)</translation>
    </message>
    <message>
        <source>Pictures of the contact shown in the last second</source>
        <translation>In der letzten Sekunde gezeigte Bilder des Kontakts</translation>
    </message>
    <message>
        <source>What draws the contact</source>
        <translation>Was den Kontakt zeichnet</translation>
    </message>
    <message>
        <source>friction coefficient μ = %1</source>
        <translation>Reibungszahl μ = %1</translation>
    </message>
    <message>
        <source>dimensionless force F̄ = %1</source>
        <translation>dimensionslose Kraft F̄ = %1</translation>
    </message>
    <message>
        <source>dimensionless velocity v̄ = %1</source>
        <translation>dimensionslose Geschwindigkeit v̄ = %1</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
</context>
<context>
    <name>asperity::TransientStrips</name>
    <message>
        <source>friction, indentation and contact length in time</source>
        <translation>Reibung, Eindringung und Kontaktlänge über der Zeit</translation>
    </message>
    <message>
        <source>nothing has moved yet</source>
        <translation>noch hat sich nichts bewegt</translation>
    </message>
    <message>
        <source>predicted rate 1/τ + v/ℓ = %1 (exact for one contact, a guide on rough lines)</source>
        <translation>vorhergesagte Rate 1/τ + v/ℓ = %1 (exakt für einen Kontakt, ein Anhalt auf rauen Linien)</translation>
    </message>
    <message>
        <source>friction μ</source>
        <translation>Reibungszahl μ</translation>
    </message>
    <message>
        <source>indentation d</source>
        <translation>Eindringung d</translation>
    </message>
    <message>
        <source>contact length ℓ</source>
        <translation>Kontaktlänge ℓ</translation>
    </message>
</context>
<context>
    <name>asperity::WindowLanguage</name>
    <message>
        <source>&amp;Language</source>
        <translation>&amp;Sprache</translation>
    </message>
    <message>
        <source>As the desktop</source>
        <translation>Wie der Desktop</translation>
    </message>
</context>
<context>
    <name>asperity::Words</name>
    <message>
        <source>position</source>
        <translation>Ort</translation>
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
        <source>friction coefficient μ</source>
        <translation>Reibungszahl μ</translation>
    </message>
    <message>
        <source>normal force F</source>
        <translation>Normalkraft F</translation>
    </message>
    <message>
        <source>indentation d</source>
        <translation>Eindringung d</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>in Kontakt</translation>
    </message>
    <message>
        <source>velocity v</source>
        <translation>Geschwindigkeit v</translation>
    </message>
    <message>
        <source>1 s on screen</source>
        <translation>1 s im Bild</translation>
    </message>
    <message>
        <source>μ in this march in time</source>
        <translation>μ in diesen Zeitschritten</translation>
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
        <source>friction F</source>
        <translation>Reibung F</translation>
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
        <source>dot: the deepest contact</source>
        <translation>Punkt: der tiefste Kontakt</translation>
    </message>
    <message>
        <source>dot: contact between two points</source>
        <translation>Punkt: Kontakt zwischen zwei Stützpunkten</translation>
    </message>
    <message>
        <source>glow: pressure, not depth</source>
        <translation>Leuchten: Druck, nicht Tiefe</translation>
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
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>one period L = %1</source>
        <translation>eine Periode L = %1</translation>
    </message>
    <message>
        <source>rms height h = %1</source>
        <translation>RMS-Höhe h = %1</translation>
    </message>
    <message>
        <source>rms slope = %1</source>
        <translation>RMS-Steigung = %1</translation>
    </message>
    <message>
        <source>Hurst exponent H = %1</source>
        <translation>Hurst-Exponent H = %1</translation>
    </message>
    <message>
        <source>Rigid line</source>
        <translation>Starre Linie</translation>
    </message>
    <message>
        <source>wave number q (1/m)</source>
        <translation>Wellenzahl q (1/m)</translation>
    </message>
    <message>
        <source>power spectral density C (m³)</source>
        <translation>Leistungsspektraldichte C (m³)</translation>
    </message>
    <message>
        <source>C ∝ q⁻²ᴴ⁻¹, cut off at π over the element spacing</source>
        <translation>C ∝ q⁻²ᴴ⁻¹, abgeschnitten bei π durch Elementabstand</translation>
    </message>
    <message>
        <source>%1 failed</source>
        <translation>%1 fehlgeschlagen</translation>
    </message>
    <message>
        <source>the line shown, at its velocity</source>
        <translation>die gezeigte Linie bei ihrer Geschwindigkeit</translation>
    </message>
</context>
</TS>
