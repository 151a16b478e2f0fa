<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en_GB">
<!-- Texts that core makes: see ui/language/translated.h. %1, %2, ... stand for the values of a template: numbers,
     keys and other texts. What shipped scenes say of themselves stands in the
     second context. Written by hand; lupdate does not know them. -->
<context>
    <name>core</name>
    <message>
        <source>has no arm with a modulus above 0</source>
        <translation>hat keinen Arm mit einem Modul über 0</translation>
    </message>
    <message>
        <source>lower end of the interval of μ</source>
        <translation>unteres Ende des Intervalls von μ</translation>
    </message>
    <message>
        <source>upper end of the interval of μ</source>
        <translation>oberes Ende des Intervalls von μ</translation>
    </message>
    <message>
        <source>tangential force Fₓ</source>
        <translation>Tangentialkraft Fₓ</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a column of this table; &apos;asperity columns&apos; lists all</source>
        <translation>„%1“ ist keine Spalte dieser Tabelle; „asperity columns“ nennt alle</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a column of this table; did you mean &apos;%2&apos;?</source>
        <translation>„%1“ ist keine Spalte dieser Tabelle; ist „%2“ gemeint?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is given more than once</source>
        <translation>„%1“ ist mehr als einmal angegeben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not NUMBER=WORDS with the number of a curve in the legend</source>
        <translation>„%1“ ist nicht NUMMER=WÖRTER mit der Nummer einer Kurve in der Legende</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a colour (#d55e00, black, grey, orange, skyblue, green, yellow, blue, vermilion, purple), a marker (circle, square, triangle, diamond, ring, no-marker) nor a line (solid, dashed, dotted, no-line)</source>
        <translation>„%1“ ist weder eine Farbe (#d55e00, black, grey, orange, skyblue, green, yellow, blue, vermilion, purple) noch eine Marke (circle, square, triangle, diamond, ring, no-marker) noch eine Linie (solid, dashed, dotted, no-line)</translation>
    </message>
    <message>
        <source>%1 is not WIDTHxHEIGHT in px, mm, cm, in or pt</source>
        <translation>%1 ist nicht BREITExHÖHE in px, mm, cm, in oder pt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not KEY=TEXT</source>
        <translation>„%1“ ist nicht SCHLÜSSEL=TEXT</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither an axis (x, y) nor a curve of this figure, which has %2 with a name</source>
        <translation>„%1“ ist weder eine Achse (x, y) noch eine Kurve dieser Abbildung, die %2 mit einem Namen hat</translation>
    </message>
    <message>
        <source>is not an option of a style; did you mean %1?</source>
        <translation>ist keine Option eines Stils; ist %1 gemeint?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a file nor one of %2</source>
        <translation>„%1“ ist weder eine Datei noch eines von %2</translation>
    </message>
    <message>
        <source>there is no curve %1 in the legend, which has %2</source>
        <translation>in der Legende gibt es keine Kurve %1; sie hat %2</translation>
    </message>
    <message>
        <source>a length</source>
        <translation>eine Länge</translation>
    </message>
    <message>
        <source>a modulus or pressure</source>
        <translation>ein Modul oder Druck</translation>
    </message>
    <message>
        <source>a force</source>
        <translation>eine Kraft</translation>
    </message>
    <message>
        <source>a velocity</source>
        <translation>eine Geschwindigkeit</translation>
    </message>
    <message>
        <source>a time</source>
        <translation>eine Zeit</translation>
    </message>
    <message>
        <source>a temperature</source>
        <translation>eine Temperatur</translation>
    </message>
    <message>
        <source>a frequency</source>
        <translation>eine Frequenz</translation>
    </message>
    <message>
        <source>a force on a length</source>
        <translation>eine Kraft je Länge</translation>
    </message>
    <message>
        <source>a viscosity</source>
        <translation>eine Viskosität</translation>
    </message>
    <message>
        <source>a mass</source>
        <translation>eine Masse</translation>
    </message>
    <message>
        <source>an energy</source>
        <translation>eine Energie</translation>
    </message>
    <message>
        <source>a power</source>
        <translation>eine Leistung</translation>
    </message>
    <message>
        <source>a voltage</source>
        <translation>eine Spannung</translation>
    </message>
    <message>
        <source>an angle</source>
        <translation>ein Winkel</translation>
    </message>
    <message>
        <source>an area</source>
        <translation>eine Fläche</translation>
    </message>
    <message>
        <source>a wave number</source>
        <translation>eine Wellenzahl</translation>
    </message>
    <message>
        <source>a pure number</source>
        <translation>eine reine Zahl</translation>
    </message>
    <message>
        <source>a difference of temperatures</source>
        <translation>ein Temperaturunterschied</translation>
    </message>
    <message>
        <source>%1 is %2; expected %3, such as %4</source>
        <translation>%1 ist %2; erwartet wird %3, zum Beispiel %4</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a known unit; expected %2, such as %3</source>
        <translation>„%1“ ist hier keine bekannte Einheit; erwartet wird %2, zum Beispiel %3</translation>
    </message>
    <message>
        <source>an energy of a mole</source>
        <translation>eine Energie je Mol</translation>
    </message>
    <message>
        <source>a share</source>
        <translation>ein Anteil</translation>
    </message>
    <message>
        <source>is not a number, so it has no range</source>
        <translation>ist keine Zahl und hat deshalb keinen Bereich</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not FROM:TO:N, such as 0.001:10:41, optionally followed by :log or :linear</source>
        <translation>„%1“ ist nicht VON:BIS:N, etwa 0.001:10:41, dahinter auf Wunsch :log oder :linear</translation>
    </message>
    <message>
        <source>%1 points are outside 1 to %2</source>
        <translation>%1 Punkte liegen außerhalb von 1 bis %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not KEY=FROM:TO:N, such as load.normal_force=0.001:10:41</source>
        <translation>„%1“ ist nicht SCHLÜSSEL=VON:BIS:N, etwa load.normal_force=0.001:10:41</translation>
    </message>
    <message>
        <source>has no meaning in this scene, so nothing depends on it</source>
        <translation>hat in dieser Szene keine Bedeutung, also hängt nichts davon ab</translation>
    </message>
    <message>
        <source>a logarithmic range needs ends above 0; %1 is not</source>
        <translation>ein logarithmischer Bereich braucht Enden über 0; %1 ist es nicht</translation>
    </message>
    <message>
        <source>reduced sliding velocity aᴛ v at %1</source>
        <translation>reduzierte Gleitgeschwindigkeit aᴛ v bei %1</translation>
    </message>
    <message>
        <source>%1 is not shown: its rubber has no shift at %2.</source>
        <translation>%1 wird nicht gezeigt: Das Elastomer hat bei %2 keine Verschiebung.</translation>
    </message>
    <message>
        <source>with local friction</source>
        <translation>mit lokaler Reibung</translation>
    </message>
    <message>
        <source>%1:%2 is not a range within %3</source>
        <translation>%1:%2 ist kein Bereich innerhalb von %3</translation>
    </message>
    <message>
        <source>the scene's %1 is outside %2 to %3</source>
        <translation>der Wert der Szene, %1, liegt außerhalb von %2 bis %3</translation>
    </message>
    <message>
        <source>unknown key</source>
        <translation>unbekannter Schlüssel</translation>
    </message>
    <message>
        <source>is not a real number, and only these can be varied; allowed in this scene: %1</source>
        <translation>ist keine reelle Zahl, und nur solche lassen sich variieren; in dieser Szene erlaubt: %1</translation>
    </message>
    <message>
        <source>has no meaning in this scene; allowed: %1</source>
        <translation>hat in dieser Szene keine Bedeutung; erlaubt: %1</translation>
    </message>
    <message>
        <source>is 0, which means none; it needs a value to begin from</source>
        <translation>ist 0, also ausgeschaltet; es braucht einen Anfangswert</translation>
    </message>
    <message>
        <source>%1 ends at its limit; the best value may lie beyond</source>
        <translation>%1 endet an seiner Grenze; der beste Wert liegt vielleicht dahinter</translation>
    </message>
    <message>
        <source>%1 is not determined by these data: its standard error is %2</source>
        <translation>%1 wird von diesen Daten nicht bestimmt: sein Standardfehler ist %2</translation>
    </message>
    <message>
        <source>%1 is not determined by these data: the standard error of its logarithm (ln) is %2</source>
        <translation>%1 wird von diesen Daten nicht bestimmt: der Standardfehler des Logarithmus (ln) ist %2</translation>
    </message>
    <message>
        <source>%1 points do not determine %2 parameters; more points than parameters are needed</source>
        <translation>%1 Punkte bestimmen keine %2 Parameter; es müssen mehr Punkte als Parameter sein</translation>
    </message>
    <message>
        <source>no parameter is named</source>
        <translation>kein Parameter ist genannt</translation>
    </message>
    <message>
        <source>the sum of squares is not a parabola along %1: its range is where the profile rises by one standard error, and the standard error is half of that range</source>
        <translation>die Summe der Quadrate ist entlang von %1 keine Parabel: der Bereich reicht bis dorthin, wo das Profil um einen Standardfehler steigt, und der Standardfehler ist die Hälfte davon</translation>
    </message>
    <message>
        <source>the spread of the %1 random lines is a larger part of the errors than the points are, and so few lines estimate it poorly: the true values may be two or three standard errors away; more lines (ensemble.realizations) make the errors smaller and better known</source>
        <translation>die Streuung der %1 zufälligen Linien ist ein größerer Teil der Fehler als die Punkte, und so wenige Linien schätzen sie schlecht: die wahren Werte können zwei oder drei Standardfehler entfernt sein; mehr Linien (ensemble.realizations) machen die Fehler kleiner und genauer bekannt</translation>
    </message>
    <message>
        <source>the spread of the %1 rows of the surface is a larger part of the errors than the points are, and so few rows estimate it poorly: the true values may be two or three standard errors away; a larger piece of the surface makes the errors smaller and better known</source>
        <translation>die Streuung der %1 Zeilen der Oberfläche ist ein größerer Teil der Fehler als die Punkte, und so wenige Zeilen schätzen sie schlecht: die wahren Werte können zwei oder drei Standardfehler entfernt sein; ein größeres Stück der Oberfläche macht die Fehler kleiner und genauer bekannt</translation>
    </message>
    <message>
        <source>the sum of squares is lower at %1 = %2, by %3: the fit has not reached its minimum; begin again from that value</source>
        <translation>die Summe der Quadrate ist bei %1 = %2 kleiner, um %3: Die Anpassung hat ihr Minimum nicht erreicht; mit diesem Wert neu beginnen</translation>
    </message>
    <message>
        <source>the fit ended before the sum of squares stopped falling</source>
        <translation>die Anpassung endete, bevor die Summe der Quadrate aufhörte zu fallen</translation>
    </message>
    <message>
        <source>the points lie further from the curve than their errors say: χ² is %1 for %2; the errors of the values are computed from errors of the points that are %3 times as large</source>
        <translation>die Punkte liegen weiter von der Kurve, als ihre Fehler sagen: χ² ist %1 bei %2; die Fehler der Werte sind aus %3-mal so großen Fehlern der Punkte berechnet</translation>
    </message>
    <message>
        <source>one point makes %1 % of the sum of squares: at %2 m/s friction is measured as %3 and computed as %4; check it, because it moves all values</source>
        <translation>ein Punkt macht %1 % der Quadratsumme aus: bei %2 m/s ist die Reibung als %3 gemessen und als %4 berechnet; prüfen Sie ihn, denn er verschiebt alle Werte</translation>
    </message>
    <message>
        <source>the fit has not found the points: computed and measured friction differ by more than a factor of two on average, and the values and their errors say nothing; begin from other values, or vary further ones</source>
        <translation>die Anpassung hat die Punkte nicht gefunden: berechnete und gemessene Reibung unterscheiden sich im Mittel um mehr als den Faktor zwei, und die Werte und ihre Fehler sagen nichts; mit anderen Werten beginnen oder weitere verändern</translation>
    </message>
    <message>
        <source>times are shifted to the temperatures of the points by the general WLF constants, C1 = %1 and C2 = %2 K, which the scene does not replace by those of its rubber</source>
        <translation>die Zeiten werden mit den allgemeinen WLF-Konstanten, C1 = %1 und C2 = %2 K, auf die Temperaturen der Punkte verschoben; die Szene ersetzt sie nicht durch die ihres Gummis</translation>
    </message>
    <message>
        <source>the data state it in each row, so that there is nothing to fit</source>
        <translation>die Daten geben es in jeder Zeile an, sodass nichts anzupassen ist</translation>
    </message>
    <message>
        <source>the scene has no friction at row %1</source>
        <translation>die Szene hat keine Reibung bei Zeile %1</translation>
    </message>
    <message>
        <source>%1 has no errors of the coefficient of friction, and %2 has; give it a column mu_error, or leave the errors out of all tables</source>
        <translation>%1 hat keine Fehler der Reibungszahl, %2 aber hat welche; eine Spalte mu_error ergänzen oder die Fehler in allen Tabellen weglassen</translation>
    </message>
    <message>
        <source>ranges: one standard error to each side, by the points' errors and the spread of the lines</source>
        <translation>Bereiche: ein Standardfehler zu jeder Seite, aus den Fehlern der Punkte und der Streuung der Linien</translation>
    </message>
    <message>
        <source>the ranges are not valid: they assume that the curve follows the points, but it misses them</source>
        <translation>die Bereiche gelten nicht: sie setzen voraus, dass die Kurve den Punkten folgt, doch sie verfehlt sie</translation>
    </message>
    <message>
        <source>the points have no errors; they scatter by %1 % about the fit, with %2</source>
        <translation>die Punkte haben keine Fehler; sie streuen um %1 % um die Anpassung, bei %2</translation>
    </message>
    <message>
        <source>χ² = %1 for %2</source>
        <translation>χ² = %1 bei %2</translation>
    </message>
    <message>
        <source>one degree of freedom</source>
        <translation>einem Freiheitsgrad</translation>
    </message>
    <message>
        <source>%1 degrees of freedom</source>
        <translation>%1 Freiheitsgraden</translation>
    </message>
    <message>
        <source>%1 (± standard error)</source>
        <translation>%1 (± Standardfehler)</translation>
    </message>
    <message>
        <source>a temperature of %1 K is too cold for rubber; name the unit, as in "temperature (C)"</source>
        <translation>eine Temperatur von %1 K ist zu kalt für Gummi; die Einheit nennen, etwa „temperature (C)“</translation>
    </message>
    <message>
        <source>column %1 has texts where numbers are expected</source>
        <translation>Spalte %1 enthält Texte, wo Zahlen erwartet werden</translation>
    </message>
    <message>
        <source>column %1: %2</source>
        <translation>Spalte %1: %2</translation>
    </message>
    <message>
        <source>column %1: %2 (%3)</source>
        <translation>Spalte %1: %2 (%3)</translation>
    </message>
    <message>
        <source>column %1: the unit %2 is unknown; known are %3</source>
        <translation>Spalte %1: die Einheit %2 ist unbekannt; bekannt sind %3</translation>
    </message>
    <message>
        <source>has %1 columns without names; name them: velocity, mu, and where there are some mu_error, normal_force, nominal_pressure, temperature, label</source>
        <translation>hat %1 Spalten ohne Namen; so benennen: velocity, mu, und wo vorhanden mu_error, normal_force, nominal_pressure, temperature, label</translation>
    </message>
    <message>
        <source>has %1 row of numbers; at least 2 are needed</source>
        <translation>hat %1 Zeile mit Zahlen; mindestens 2 werden gebraucht</translation>
    </message>
    <message>
        <source>has no column of the %1; its columns are %2; name it as in "%3"</source>
        <translation>hat keine Spalte mit %1; die Spalten sind %2; nennen Sie sie wie in „%3“</translation>
    </message>
    <message>
        <source>has the velocity of row %1, %2 m/s; average repeated measurements and give their error as mu_error, or tell them apart by a label</source>
        <translation>hat die Geschwindigkeit von Zeile %1, %2 m/s; wiederholte Messungen mitteln und ihren Fehler als mu_error angeben, oder mit einem Label unterscheiden</translation>
    </message>
    <message>
        <source>has two columns of the %1: %2 and %3</source>
        <translation>hat zwei Spalten mit %1: %2 und %3</translation>
    </message>
    <message>
        <source>has both a normal force and a nominal pressure, which are not those of one sample: their quotient is %1 to %2 cm²; take the column out that does not say the load</source>
        <translation>hat Normalkraft und nominellen Druck, die nicht zu einer Probe gehören: ihr Quotient ist %1 bis %2 cm²; die Spalte weglassen, die nicht die Last angibt</translation>
    </message>
    <message>
        <source>the nominal pressure says the load; the normal force, on a sample of %1 cm², is not used</source>
        <translation>der nominelle Druck gibt die Last an; die Normalkraft, auf einer Probe von %1 cm², wird nicht verwendet</translation>
    </message>
    <message>
        <source>row %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>the %1 is %2, which is not above 0</source>
        <translation>%1: %2 ist nicht größer als 0</translation>
    </message>
    <message>
        <source>rows left out, because the %1 is missing: lines %2</source>
        <translation>weggelassene Zeilen, weil der Wert fehlt (%1): %2</translation>
    </message>
    <message>
        <source>column %1: the %2 is missing in all rows; take the column out</source>
        <translation>Spalte %1: der Wert fehlt in allen Zeilen (%2); die Spalte herausnehmen</translation>
    </message>
    <message>
        <source>has %1 row of numbers; at least 2 are needed (%2)</source>
        <translation>hat %1 Zeile mit Zahlen; mindestens 2 sind nötig (%2)</translation>
    </message>
    <message>
        <source>the rows of one %1 are one isotherm, at the mean of their temperatures, which differ from it by up to %2</source>
        <translation>die Zeilen mit gleichem Wert in %1 sind eine Isotherme, beim Mittel ihrer Temperaturen, die davon um bis zu %2 abweichen</translation>
    </message>
    <message>
        <source>The %1 columns are taken for the lines whose number or spacing the header states: they are the rows of the surface, unless surface.format is matrix.</source>
        <translation>Die %1 Spalten werden für die Linien gehalten, deren Zahl oder Abstand der Kopf nennt: Sie sind die Zeilen der Oberfläche, außer wenn surface.format matrix ist.</translation>
    </message>
    <message>
        <source>in the names of the columns: %1</source>
        <translation>in den Namen der Spalten: %1</translation>
    </message>
    <message>
        <source>the error of the velocity is below 0</source>
        <translation>der Fehler der Geschwindigkeit ist kleiner als 0</translation>
    </message>
    <message>
        <source>error of the coefficient of friction</source>
        <translation>Fehler der Reibungszahl</translation>
    </message>
    <message>
        <source>error of the velocity</source>
        <translation>Fehler der Geschwindigkeit</translation>
    </message>
    <message>
        <source>label</source>
        <translation>Label</translation>
    </message>
    <message>
        <source>%1 is named twice</source>
        <translation>%1 ist zweimal genannt</translation>
    </message>
    <message>
        <source>a list of %1</source>
        <translation>eine Liste aus %1</translation>
    </message>
    <message>
        <source>a list of 0 to %1 {file, label}</source>
        <translation>eine Liste von 0 bis %1 {file, label}</translation>
    </message>
    <message>
        <source>has %1 tables; allowed is %2</source>
        <translation>hat %1 Tabellen; erlaubt ist %2</translation>
    </message>
    <message>
        <source>needs an object of file and label</source>
        <translation>braucht ein Objekt aus file und label</translation>
    </message>
    <message>
        <source>unknown key; a table has file and label</source>
        <translation>unbekannter Schlüssel; eine Tabelle hat file und label</translation>
    </message>
    <message>
        <source>is not a text</source>
        <translation>ist kein Text</translation>
    </message>
    <message>
        <source>measured / computed</source>
        <translation>gemessen / berechnet</translation>
    </message>
    <message>
        <source>fit ± standard error</source>
        <translation>Anpassung ± Standardfehler</translation>
    </message>
    <message>
        <source>What the data say about each parameter</source>
        <translation>Was die Daten über jeden Parameter sagen</translation>
    </message>
    <message>
        <source>The least sum of squares with one parameter held: flat where the data leave it open. Its points are at most one standard error apart, which holds the spread of the lines, too; the sum of squares does not.</source>
        <translation>Die kleinste Summe der Quadrate bei einem festgehaltenen Parameter: flach, wo die Daten ihn offen lassen. Ihre Punkte liegen höchstens einen Standardfehler auseinander, der auch die Streuung der Linien enthält; die Summe der Quadrate enthält sie nicht.</translation>
    </message>
    <message>
        <source>χ² above its minimum</source>
        <translation>χ² über dem Minimum</translation>
    </message>
    <message>
        <source>Gaussian foundation, low velocity</source>
        <translation>Gaußsche Linie auf Bettung, kleine Geschwindigkeit</translation>
    </message>
    <message>
        <source>complete contact</source>
        <translation>Vollkontakt</translation>
    </message>
    <message>
        <source>half-space, with long-range elasticity</source>
        <translation>Halbraum, mit langreichweitiger Elastizität</translation>
    </message>
    <message>
        <source>shear velocity</source>
        <translation>Schubgeschwindigkeit</translation>
    </message>
    <message>
        <source>shear width</source>
        <translation>Schubbreite</translation>
    </message>
    <message>
        <source>measured friction</source>
        <translation>gemessene Reibung</translation>
    </message>
    <message>
        <source>theories</source>
        <translation>Theorien</translation>
    </message>
    <message>
        <source>Velocity (times the temperature shift) at which the local shear is largest; 0: it does not depend on the velocity.</source>
        <translation>Geschwindigkeit (mal Temperaturverschiebung), bei der der lokale Schub am größten ist; 0: Er hängt nicht von der Geschwindigkeit ab.</translation>
    </message>
    <message>
        <source>How fast the local shear falls beside that velocity: it is exp(-c) of its largest value a decade away.</source>
        <translation>Wie schnell der lokale Schub neben dieser Geschwindigkeit abfällt: Eine Dekade daneben ist er exp(-c) mal sein größter Wert.</translation>
    </message>
    <message>
        <source>Tables of measured friction that are shown beside the curve: velocity and mu, with or without errors, force, temperature.</source>
        <translation>Tabellen gemessener Reibung, die neben der Kurve gezeigt werden: velocity und mu, mit oder ohne Fehler, Kraft, Temperatur.</translation>
    </message>
    <message>
        <source>Theories that are drawn beside the curve.</source>
        <translation>Theorien, die neben der Kurve gezeichnet werden.</translation>
    </message>
    <message>
        <source>Eq. (11) of Li et al. (2013): self-affine lines, Kelvin elements, contact of many summits.</source>
        <translation>Gl. (11) von Li et al. (2013): selbstaffine Linien, Kelvin-Elemente, Kontakt vieler Gipfel.</translation>
    </message>
    <message>
        <source>Gaussian line on independent elements as the velocity goes to 0, without a fitted constant; it needs three independent waves in contact.</source>
        <translation>Gaußsche Linie auf unabhängigen Elementen bei verschwindender Geschwindigkeit, ohne angepasste Konstante; sie braucht drei unabhängige Wellen im Kontakt.</translation>
    </message>
    <message>
        <source>Losses of all waves of the line in complete contact, for any linear rheology; below complete contact it is too large.</source>
        <translation>Verluste aller Wellen der Linie bei Vollkontakt, für jede lineare Rheologie; darunter ist sie zu groß.</translation>
    </message>
    <message>
        <source>Persson (2001) for the isotropic surface that this line is equivalent to, at its nominal pressure: another model, whose elements feel each other.</source>
        <translation>Persson (2001) für die isotrope Fläche, der diese Linie entspricht, bei ihrem nominellen Druck: ein anderes Modell, dessen Elemente einander spüren.</translation>
    </message>
    <message>
        <source>the file name has no extension; allowed is %1</source>
        <translation>der Name hat keine Endung; erlaubt ist %1</translation>
    </message>
    <message>
        <source>%1 is not one of %2</source>
        <translation>%1 ist keines von %2</translation>
    </message>
    <message>
        <source>%1 is not %2</source>
        <translation>%1 ist nicht %2</translation>
    </message>
    <message>
        <source>%1, and it is %2 m</source>
        <translation>%1, und d ist %2 m</translation>
    </message>
    <message>
        <source>1.5 to 2.5</source>
        <translation>1,5 bis 2,5</translation>
    </message>
    <message>
        <source>Fig. %1: %2</source>
        <translation>Abb. %1: %2</translation>
    </message>
    <message>
        <source>above %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>within %1 of %2</source>
        <translation>höchstens %1 von %2 entfernt</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>below %1, on at least one point</source>
        <translation>unter %1, an mindestens einem Punkt</translation>
    </message>
    <message>
        <source>at most %1, and no negative pressure</source>
        <translation>höchstens %1 und kein negativer Druck</translation>
    </message>
    <message>
        <source>spacing %1 after data row %2 differs from %3; positions must be uniform to %4</source>
        <translation>der Abstand %1 nach Datenzeile %2 unterscheidet sich von %3; die Orte müssen auf %4 gleichabständig sein</translation>
    </message>
    <message>
        <source>is a link to &apos;%1&apos;, which does not exist</source>
        <translation>ist ein Verweis auf „%1“, das es nicht gibt</translation>
    </message>
    <message>
        <source>needs one of %1 behind it</source>
        <translation>braucht eines von %1 dahinter</translation>
    </message>
    <message>
        <source>is not valid JSON: line %1, column %2: %3</source>
        <translation>ist kein gültiges JSON: Zeile %1, Spalte %2 (auf Englisch: %3)</translation>
    </message>
    <message>
        <source>line %1 states a Poisson&apos;s ratio of %2, and %3 is used; --poisson-ratio replaces it</source>
        <translation>Zeile %1 nennt eine Querkontraktionszahl von %2, und %3 wird verwendet; --poisson-ratio ersetzt sie</translation>
    </message>
    <message>
        <source>The numbers begin with their highest byte (big-endian), against the standard, and are read so.</source>
        <translation>Die Zahlen beginnen mit ihrem höchsten Byte (Big-Endian), gegen die Norm, und werden so gelesen.</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>lässt sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>lässt sich nicht lesen: %1</translation>
    </message>
    <message>
        <source>folder %1 does not exist</source>
        <translation>den Ordner %1 gibt es nicht</translation>
    </message>
    <message>
        <source>folder %1 cannot be written to</source>
        <translation>in den Ordner %1 kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>die Datei gibt es nicht</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>kein Platz mehr auf dem Datenträger</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>das Dateisystem ist nur lesbar</translation>
    </message>
    <message>
        <source>p. 2, Eq. (3)</source>
        <translation>S. 2, Gl. (3)</translation>
    </message>
    <message>
        <source>p. 2, Eqs. (1) and (2)</source>
        <translation>S. 2, Gln. (1) und (2)</translation>
    </message>
    <message>
        <source>p. 2, Fig. 2</source>
        <translation>S. 2, Abb. 2</translation>
    </message>
    <message>
        <source>p. 2, Fig. 3</source>
        <translation>S. 2, Abb. 3</translation>
    </message>
    <message>
        <source>p. 2, Fig. 4</source>
        <translation>S. 2, Abb. 4</translation>
    </message>
    <message>
        <source>p. 3, Eq. (11), Fig. 3</source>
        <translation>S. 3, Gl. (11), Abb. 3</translation>
    </message>
    <message>
        <source>p. 3, Eq. (7), Fig. 5</source>
        <translation>S. 3, Gl. (7), Abb. 5</translation>
    </message>
    <message>
        <source>p. 3, Eq. (9), Fig. 6</source>
        <translation>S. 3, Gl. (9), Abb. 6</translation>
    </message>
    <message>
        <source>p. 3, Eqs. (5) and (7)</source>
        <translation>S. 3, Gln. (5) und (7)</translation>
    </message>
    <message>
        <source>p. 3, Fig. 6</source>
        <translation>S. 3, Abb. 6</translation>
    </message>
    <message>
        <source>p. 4, Eqs. (16) and (17)</source>
        <translation>S. 4, Gln. (16) und (17)</translation>
    </message>
    <message>
        <source>p. 4, Fig. 6</source>
        <translation>S. 4, Abb. 6</translation>
    </message>
    <message>
        <source>p. 3, Eq. (8)</source>
        <translation>S. 3, Gl. (8)</translation>
    </message>
    <message>
        <source>p. 3, Eq. (9)</source>
        <translation>S. 3, Gl. (9)</translation>
    </message>
    <message>
        <source>p. 3, Eq. (6)</source>
        <translation>S. 3, Gl. (6)</translation>
    </message>
    <message>
        <source>p. 3, Eq. (12)</source>
        <translation>S. 3, Gl. (12)</translation>
    </message>
    <message>
        <source>p. 4, Eq. (15)</source>
        <translation>S. 4, Gl. (15)</translation>
    </message>
    <message>
        <source>p. 3, Eqs. (13) and (14)</source>
        <translation>S. 3, Gln. (13) und (14)</translation>
    </message>
    <message>
        <source>a JPEG picture</source>
        <translation>ein JPEG-Bild</translation>
    </message>
    <message>
        <source>a GIF picture</source>
        <translation>ein GIF-Bild</translation>
    </message>
    <message>
        <source>a TIFF picture</source>
        <translation>ein TIFF-Bild</translation>
    </message>
    <message>
        <source>a RIFF file (as WebP is)</source>
        <translation>eine RIFF-Datei (wie WebP)</translation>
    </message>
    <message>
        <source>an old Office document</source>
        <translation>ein altes Office-Dokument</translation>
    </message>
    <message>
        <source>a gzip archive</source>
        <translation>ein gzip-Archiv</translation>
    </message>
    <message>
        <source>an xz archive</source>
        <translation>ein xz-Archiv</translation>
    </message>
    <message>
        <source>a zstd archive</source>
        <translation>ein zstd-Archiv</translation>
    </message>
    <message>
        <source>an HDF5 file</source>
        <translation>eine HDF5-Datei</translation>
    </message>
    <message>
        <source>a WebM film</source>
        <translation>ein WebM-Film</translation>
    </message>
    <message>
        <source>%1 % of the contact is on slopes that climb (100 %: one-sided, 50 %: both sides alike); rms slope in contact %2 times that of the line.</source>
        <translation>%1 % des Kontakts liegen auf steigenden Flanken (100 %: einseitig, 50 %: beide Seiten gleich); RMS-Steigung im Kontakt: %2-mal die der Linie.</translation>
    </message>
    <message>
        <source>%1 (%2 lines)</source>
        <translation>%1 (%2 Linien)</translation>
    </message>
    <message>
        <source>%1 (1 line)</source>
        <translation>%1 (1 Linie)</translation>
    </message>
    <message>
        <source>%1 K is not above %2 K, reference_temperature - c2, where the shift ends</source>
        <translation>%1 K liegt nicht über %2 K, Bezugstemperatur - c2, wo die Verschiebung endet</translation>
    </message>
    <message>
        <source>%1 K shifts the times by %2 decades; allowed is %3</source>
        <translation>%1 K verschiebt die Zeiten um %2 Dekaden; erlaubt sind %3</translation>
    </message>
    <message>
        <source>%1 N/m in contact are reported separately</source>
        <translation>%1 N/m im Kontakt werden getrennt ausgewiesen</translation>
    </message>
    <message>
        <source>%1 Pa is neither 0 nor at least %2 Pa</source>
        <translation>%1 Pa ist weder 0 noch mindestens %2 Pa</translation>
    </message>
    <message>
        <source>%1 is above sweep.velocity_to, %2</source>
        <translation>%1 liegt über sweep.velocity_to, %2</translation>
    </message>
    <message>
        <source>%1 is beyond what a number can hold; allowed is %2</source>
        <translation>%1 ist größer, als eine Zahl sein kann; erlaubt ist %2</translation>
    </message>
    <message>
        <source>%1 is not a finite number; allowed is %2</source>
        <translation>%1 ist keine endliche Zahl; erlaubt ist %2</translation>
    </message>
    <message>
        <source>%1 is not a whole number; allowed is %2</source>
        <translation>%1 ist keine ganze Zahl; erlaubt ist %2</translation>
    </message>
    <message>
        <source>%1 is not allowed here; allowed is %2</source>
        <translation>%1 ist hier nicht erlaubt; erlaubt ist %2</translation>
    </message>
    <message>
        <source>%1 is outside %2</source>
        <translation>%1 liegt außerhalb von %2</translation>
    </message>
    <message>
        <source>%1 is outside 1 to %2, what %3 elements carry</source>
        <translation>%1 liegt außerhalb von 1 bis %2, was %3 Elemente tragen</translation>
    </message>
    <message>
        <source>%1 lines of %2 elements, 8 velocities in each region</source>
        <translation>%1 Linien mit %2 Elementen; 8 Geschwindigkeiten je Bereich</translation>
    </message>
    <message>
        <source>%1 minus the curve above</source>
        <translation>%1 minus die Kurve darüber</translation>
    </message>
    <message>
        <source>%1 needs steady sliding, not %2</source>
        <translation>%1 braucht stationäres Gleiten, nicht %2</translation>
    </message>
    <message>
        <source>%1 points of complete contact. Against the slope of the spectrum the difference is %2: the resolution of the line, which falls with the oversampling.</source>
        <translation>%1 Punkte im Vollkontakt. Gegenüber der Steigung des Spektrums ist der Unterschied %2: die Auflösung der Linie; er fällt mit der Überabtastung.</translation>
    </message>
    <message>
        <source>%1 time steps would give %2 rows, more than %3; each %4th step gives fewer</source>
        <translation>%1 Zeitschritte ergäben %2 Zeilen, mehr als %3; jeder %4. Schritt gibt weniger</translation>
    </message>
    <message>
        <source>%1 to %2 %3</source>
        <translation>%1 bis %2 %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>%1. In complete contact it grows as the force. The detachment condition of the paper lacks a factor G: G (d - z) + η v z′ = 0.</source>
        <translation>%1. Im Vollkontakt wächst sie wie die Kraft. Der Ablösebedingung der Arbeit fehlt ein Faktor G: G (d - z) + η v z′ = 0.</translation>
    </message>
    <message>
        <source>%1. It depends on the window: with Fₙ / G h L up to 1 the largest deviation is %2.</source>
        <translation>%1. Es hängt vom Fenster ab: Mit Fₙ / G h L bis 1 ist die größte Abweichung %2.</translation>
    </message>
    <message>
        <source>%1. Region IV belongs to the finite period: an endless line should keep its plateau.</source>
        <translation>%1. Bereich IV gehört zur endlichen Periode: Eine endlose Linie sollte ihr Plateau behalten.</translation>
    </message>
    <message>
        <source>%1. With the rms slope of the whole line for that in contact. The term of partial contact, with α and β, lowers Eq. (11) by at most %2 % at this force: the figure does not test it.</source>
        <translation>%1. Mit der RMS-Steigung der ganzen Linie anstelle der im Kontakt. Das Glied des Teilkontakts mit α und β senkt Gl. (11) bei dieser Kraft um höchstens %2 %: Das Bild prüft es nicht.</translation>
    </message>
    <message>
        <source>%1: its length %2 m is outside %3</source>
        <translation>%1: seine Länge %2 m liegt außerhalb von %3</translation>
    </message>
    <message>
        <source>%1; beyond, %2 of them per spacing are too few for 1 %, and any fixed number has a floor of its own.</source>
        <translation>%1; darüber sind %2 je Abstand zu wenige für 1 %, und jede feste Zahl hat ihren eigenen Boden.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not %2</source>
        <translation>„%1“ ist nicht %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not KEY=VALUE</source>
        <translation>„%1“ ist nicht SCHLÜSSEL=WERT</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a number; allowed is %2</source>
        <translation>„%1“ ist keine Zahl; erlaubt ist %2</translation>
    </message>
    <message>
        <source>1 internal variable an element</source>
        <translation>1 innere Variable je Element</translation>
    </message>
    <message>
        <source>1 line</source>
        <translation>1 Linie</translation>
    </message>
    <message>
        <source>1 line of %1 elements, 8 velocities in each region</source>
        <translation>1 Linie mit %1 Elementen; 8 Geschwindigkeiten je Bereich</translation>
    </message>
    <message>
        <source>At %1 m/s, smallest at H = %2.</source>
        <translation>Bei %1 m/s, am kleinsten für H = %2.</translation>
    </message>
    <message>
        <source>At %1 m/s. Fₙ(d) of separate elements jumps where one enters under viscous pressure; on a resolved line it is continuous and every balance is met to %2.</source>
        <translation>Bei %1 m/s. Fₙ(d) getrennter Elemente springt, wo eines unter viskosem Druck eintritt; auf einer aufgelösten Linie ist Fₙ(d) stetig und jedes Gleichgewicht auf %2 erfüllt.</translation>
    </message>
    <message>
        <source>At %1 m/s. Mind the fall already at this small force.</source>
        <translation>Bei %1 m/s. Zu beachten ist der Abfall schon bei dieser kleinen Kraft.</translation>
    </message>
    <message>
        <source>C(q) is two-sided, h² = 2 ∫ C dq; cut off at π over the element spacing. Points are means over equal intervals of log q.</source>
        <translation>C(q) ist zweiseitig, h² = 2 ∫ C dq; abgeschnitten bei π/Elementabstand. Punkte sind Mittel über gleiche Intervalle von log q.</translation>
    </message>
    <message>
        <source>C(q) ~ q⁻²ᴴ⁻¹ is two-sided, h² = 2 ∫ C dq; cut off at π over the element spacing. Points are means over equal intervals of log q.</source>
        <translation>C(q) ~ q⁻²ᴴ⁻¹ ist zweiseitig, h² = 2 ∫ C dq; abgeschnitten bei π/Elementabstand. Punkte sind Mittel über gleiche Intervalle von log q.</translation>
    </message>
    <message>
        <source>Circles: spread of the means over groups of so many lines. Lines: one over the square root.</source>
        <translation>Kreise: Streuung der Mittel über Gruppen von so vielen Linien. Linien: eins durch die Wurzel.</translation>
    </message>
    <message>
        <source>Eq. (12) sets β = 1 without saying so and is low by that factor in region I. β by H: %1.</source>
        <translation>Gl. (12) setzt β = 1, ohne es zu sagen, und ist im Bereich I um diesen Faktor zu klein. β nach H: %1.</translation>
    </message>
    <message>
        <source>Eq. (15)&apos;s exponents must read +2(1 - H). With them, and with the whole contact taken as one piece, whose length is the longest wave in contact, it gives the expected value; the real contact is in many pieces, which are shorter.</source>
        <translation>Die Exponenten in Gl. (15) müssen +2(1 - H) lauten. Mit ihnen und mit dem ganzen Kontakt als einem Stück, dessen Länge die längste Welle im Kontakt ist, ergibt sich der erwartete Wert; der wirkliche Kontakt besteht aus vielen kürzeren Stücken.</translation>
    </message>
    <message>
        <source>Errors against cubic at two high resolutions, extrapolated. The literal march and nodal are other models at the smallest scale: theirs is a difference, not an error. Processor time of one thread, medians of repeated runs, with the share of one velocity of the sweep in making the line.</source>
        <translation>Fehler gegen das kubische Verfahren bei zwei hohen Auflösungen, extrapoliert. Die wörtlichen Zeitschritte und das nodale Verfahren sind auf der kleinsten Skala andere Modelle: Bei ihnen ist es ein Unterschied, kein Fehler. Prozessorzeit eines Threads, Mediane wiederholter Läufe, mit dem Anteil einer Geschwindigkeit der Kurve an der Herstellung der Linie.</translation>
    </message>
    <message>
        <source>Fine steps of the same N elements are resolved up to %1 m/s</source>
        <translation>Feine Schritte derselben N Elemente sind bis %1 m/s aufgelöst</translation>
    </message>
    <message>
        <source>Fine steps of the same N elements give n = %1 between %2 and %3 m/s</source>
        <translation>Feine Schritte derselben N Elemente geben n = %1 zwischen %2 und %3 m/s</translation>
    </message>
    <message>
        <source>Friction itself falls to %1 of its maximum. Over the slope in contact it goes from %2 to %3. On a smooth summit, where the slope in contact is evenly distributed, it is 2/√3 = %4.</source>
        <translation>Die Reibung selbst fällt auf %1 ihres Maximums. Bezogen auf die Steigung im Kontakt geht sie von %2 auf %3. Auf einem glatten Gipfel, wo die Steigung im Kontakt gleichverteilt ist, ist sie 2/√3 = %4.</translation>
    </message>
    <message>
        <source>From %1 to %2. √2 assumes exponentially distributed slopes; random phases give Gaussian ones, for which Eq. (10) is 1.253 times the slope in contact, and 1.596 where the contact is weighted by the slope. Eq. (10)&apos;s second line lacks the square root of the contact length as a factor.</source>
        <translation>Von %1 bis %2. √2 setzt exponentiell verteilte Steigungen voraus; Zufallsphasen ergeben normalverteilte, für die Gl. (10) das 1,253-Fache der Steigung im Kontakt ist und das 1,596-Fache, wo der Kontakt mit der Steigung gewichtet ist. Der zweiten Zeile von Gl. (10) fehlt die Wurzel der Kontaktlänge als Faktor.</translation>
    </message>
    <message>
        <source>From 90 % of the line to 90 % of the maximum it is %1. Region II cannot both begin on the line of slope 1 and grow by two only within a decade.</source>
        <translation>Von 90 % der Geraden bis 90 % des Maximums ist er %1. Bereich II kann nicht zugleich auf der Geraden der Steigung 1 beginnen und innerhalb einer Dekade nur um den Faktor zwei wachsen.</translation>
    </message>
    <message>
        <source>Fₙ/GhL = %1: up to %2 % of the maximum, at %3 of the %4 points, the whole line is in contact, and the curves are Eq. (8), which has no fitted number.</source>
        <translation>Fₙ/GhL = %1: bis %2 % des Maximums, an %3 der %4 Punkte, ist die ganze Linie im Kontakt, und die Kurven sind Gl. (8), die keine angepasste Zahl hat.</translation>
    </message>
    <message>
        <source>In the limit of low velocity. α depends on the range of forces that it is fitted to; β belongs to α = H/(1 + H). Bars: one standard error.</source>
        <translation>Im Grenzfall kleiner Geschwindigkeit. α hängt vom Bereich der Kräfte ab, an den es angepasst wird; β gehört zu α = H/(1 + H). Balken: ein Standardfehler.</translation>
    </message>
    <message>
        <source>N elements, fine steps</source>
        <translation>N Elemente, feine Schritte</translation>
    </message>
    <message>
        <source>Points: averages with one standard error. Lines: Eq. (11) with the rms slope of the whole line, α = H/(1 + H) and β as measured (Fig. 5).</source>
        <translation>Punkte: Mittelwerte mit einem Standardfehler. Linien: Gl. (11) mit der RMS-Steigung der ganzen Linie, α = H/(1 + H) und gemessenem β (Abb. 5).</translation>
    </message>
    <message>
        <source>Regions by 80 % of the line through region I and 95 % of the maximum. In region IV the smallest scale decides: the constant level appears only where the line moves one spacing in each step.</source>
        <translation>Bereichsgrenzen bei 80 % der Geraden durch Bereich I und 95 % des Maximums. Im Bereich IV entscheidet die kleinste Skala: Das konstante Niveau erscheint nur, wo die Linie in jedem Schritt um einen Abstand weiterrückt.</translation>
    </message>
    <message>
        <source>Shifted with the rms slope in contact at low velocity; f is where region I of Eq. (11) meets the plateau. Region IV is not part of Eq. (12) and does not collapse.</source>
        <translation>Verschoben mit der RMS-Steigung im Kontakt bei kleiner Geschwindigkeit; f ist, wo Bereich I von Gl. (11) auf das Plateau trifft. Bereich IV gehört nicht zu Gl. (12) und fällt nicht zusammen.</translation>
    </message>
    <message>
        <source>The curve of fine steps ends at %1 m/s, above which %2 steps per spacing are too few for 1 %.</source>
        <translation>Die Kurve der feinen Schritte endet bei %1 m/s; darüber sind %2 Schritte je Abstand zu wenige für 1 %.</translation>
    </message>
    <message>
        <source>The maximum of each averaged curve μ(v), with one standard error. √2 assumes exponentially distributed slopes; a line of random phases has Gaussian ones.</source>
        <translation>Das Maximum jeder gemittelten Kurve μ(v), mit einem Standardfehler. √2 setzt exponentiell verteilte Steigungen voraus; eine Linie mit Zufallsphasen hat normalverteilte.</translation>
    </message>
    <message>
        <source>The paper does not say where it reads the borders. From 90 % of the line to 90 % of the maximum it is %1 decades.</source>
        <translation>Die Arbeit sagt nicht, wo sie die Grenzen abliest. Von 90 % der Geraden bis 90 % des Maximums sind es %1 Dekaden.</translation>
    </message>
    <message>
        <source>The paper&apos;s own condition for leaving the contact is f &gt; 0, not u &lt; z - d alone. With the detachment condition d - z + η v z′ = 0 a factor G is missing: G (d - z) + η v z′ = 0.</source>
        <translation>Die Bedingung der Arbeit selbst für das Verlassen des Kontakts ist f &gt; 0, nicht u &lt; z - d allein. In der Ablösebedingung d - z + η v z′ = 0 fehlt ein Faktor G: G (d - z) + η v z′ = 0.</translation>
    </message>
    <message>
        <source>The third curve from the left is that of Fig. 2. In zone 1 curves shift as Fₙ to the power H/(1 + H), in zone 2 as Fₙ.</source>
        <translation>Die dritte Kurve von links ist die aus Abb. 2. In Zone 1 verschieben sich die Kurven wie Fₙ hoch H/(1 + H), in Zone 2 wie Fₙ.</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>a PNG picture</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a ZIP archive (as of a spreadsheet)</source>
        <translation>ein ZIP-Archiv (etwa einer Tabellenkalkulation)</translation>
    </message>
    <message>
        <source>a binary file</source>
        <translation>eine Binärdatei</translation>
    </message>
    <message>
        <source>a comparison of curves</source>
        <translation>ein Vergleich von Kurven</translation>
    </message>
    <message>
        <source>a constant force</source>
        <translation>einer konstanten Kraft</translation>
    </message>
    <message>
        <source>a kelvin body</source>
        <translation>einem kelvin-Körper</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a list of 0 to %1 {modulus, relaxation_time}, %2 and %3</source>
        <translation>eine Liste von 0 bis %1 {modulus, relaxation_time}, %2 und %3</translation>
    </message>
    <message>
        <source>a number is not %1</source>
        <translation>eine Zahl ist nicht %1</translation>
    </message>
    <message>
        <source>a rough line: more than 0</source>
        <translation>einer rauen Linie: mehr als 0</translation>
    </message>
    <message>
        <source>a scene is JSON in UTF-8; a measured surface is a file that a scene names as surface.file, with surface.kind measured</source>
        <translation>eine Szene ist JSON in UTF-8; eine gemessene Oberfläche ist eine Datei, die eine Szene als surface.file nennt, mit surface.kind measured</translation>
    </message>
    <message>
        <source>a self_affine line</source>
        <translation>einer self_affine-Linie</translation>
    </message>
    <message>
        <source>a viscoelastic body: more than 0</source>
        <translation>einem viskoelastischen Körper: mehr als 0</translation>
    </message>
    <message>
        <source>accuracy.target_relative_error needs about %1 lines at one velocity, and at most %2 are computed: the run takes about %3 and may miss the target</source>
        <translation>accuracy.target_relative_error braucht bei einer Geschwindigkeit etwa %1 Linien, und höchstens %2 werden berechnet: Der Lauf dauert etwa %3 und verfehlt womöglich das Ziel</translation>
    </message>
    <message>
        <source>accuracy.target_relative_error needs about %1 lines at one velocity, and the run takes about %2; half the error needs four times as many lines</source>
        <translation>accuracy.target_relative_error braucht bei einer Geschwindigkeit etwa %1 Linien, und der Lauf dauert etwa %2; der halbe Fehler braucht viermal so viele Linien</translation>
    </message>
    <message>
        <source>the standard error is not known before the run: most of the lines that were tried are just in complete contact, where all have the same friction; other lines may not be</source>
        <translation>der Standardfehler ist vor dem Lauf nicht bekannt: Die meisten der versuchten Linien haben gerade vollständigen Kontakt, in dem die Reibung aller gleich ist; andere Linien womöglich nicht</translation>
    </message>
    <message>
        <source>accuracy.target_relative_error is not reached: %1; the mean over all rows of the surface is uncertain by %2, which only a larger piece of the surface lowers</source>
        <translation>accuracy.target_relative_error wird nicht erreicht: %1; das Mittel über alle Zeilen der Oberfläche ist um %2 unsicher, was nur ein größeres Stück der Oberfläche verringert</translation>
    </message>
    <message>
        <source>accuracy.target_relative_error is not reached within the lines and memory allowed: %1</source>
        <translation>accuracy.target_relative_error wird mit den erlaubten Linien und dem erlaubten Speicher nicht erreicht: %1</translation>
    </message>
    <message>
        <source>an empty file</source>
        <translation>eine leere Datei</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>an output needs a name</source>
        <translation>eine Ausgabe braucht einen Namen</translation>
    </message>
    <message>
        <source>at %1 K all relaxation times are %2 times as long</source>
        <translation>bei %1 K sind alle Relaxationszeiten %2-mal so lang</translation>
    </message>
    <message>
        <source>at velocity %1 m/s</source>
        <translation>bei der Geschwindigkeit %1 m/s</translation>
    </message>
    <message>
        <source>below 1e-9</source>
        <translation>unter 1e-9</translation>
    </message>
    <message>
        <source>cannot be written: %1</source>
        <translation>lässt sich nicht schreiben: %1</translation>
    </message>
    <message>
        <source>contact is complete above d = %1 m at %2 m/s</source>
        <translation>bei %2 m/s ist der Kontakt ab d = %1 m vollständig</translation>
    </message>
    <message>
        <source>contact is too short, or the moduli differ too much, for double precision, %1</source>
        <translation>der Kontakt ist zu kurz, oder die Moduln unterscheiden sich zu stark, für doppelte Genauigkeit, %1</translation>
    </message>
    <message>
        <source>edges of contact are found inside the segments: %1</source>
        <translation>Kontaktränder werden innerhalb der Segmente gefunden: %1</translation>
    </message>
    <message>
        <source>figure %1 of the paper is about %2</source>
        <translation>Abbildung %1 der Arbeit handelt von %2</translation>
    </message>
    <message>
        <source>figure %1 sets it itself</source>
        <translation>Abbildung %1 setzt es selbst</translation>
    </message>
    <message>
        <source>has %1 arms; allowed is %2</source>
        <translation>hat %1 Arme; erlaubt ist %2</translation>
    </message>
    <message>
        <source>has %1 rows of numbers; at least 3 are needed</source>
        <translation>hat %1 Zeilen mit Zahlen; mindestens 3 sind nötig</translation>
    </message>
    <message>
        <source>is %1; %2</source>
        <translation>ist %1; %2</translation>
    </message>
    <message>
        <source>is %1; a profile is CSV in UTF-8</source>
        <translation>ist %1; ein Profil ist CSV in UTF-8</translation>
    </message>
    <message>
        <source>is 0, and there are neither arms nor a dashpot: the elastomer would have no force</source>
        <translation>ist 0, und es gibt weder Arme noch einen Dämpfer; das Elastomer hätte keine Kraft</translation>
    </message>
    <message>
        <source>is not a list in JSON; allowed is %1</source>
        <translation>ist keine Liste in JSON; erlaubt ist %1</translation>
    </message>
    <message>
        <source>is not a number; allowed is %1</source>
        <translation>ist keine Zahl; erlaubt ist %1</translation>
    </message>
    <message>
        <source>is steady, so nothing changes in time; %1 needs start, step, oscillation or reversal</source>
        <translation>ist stationär, daher ändert sich nichts mit der Zeit; %1 braucht start, step, oscillation oder reversal</translation>
    </message>
    <message>
        <source>n is %1 on the resolved line, which falls on as 1/√v. The level is one node&apos;s own slope: the line moves one spacing per step, so the last contact is a single node, and more power goes in than is dissipated. %2</source>
        <translation>n ist %1 auf der aufgelösten Linie, die wie 1/√v weiter fällt. Das Niveau ist die Steigung eines einzelnen Knotens: Die Linie rückt je Schritt um einen Abstand weiter, daher ist der letzte Kontakt ein einziger Knoten, und es geht mehr Leistung hinein, als dissipiert wird. %2</translation>
    </message>
    <message>
        <source>needs %1</source>
        <translation>braucht %1</translation>
    </message>
    <message>
        <source>on realization %1</source>
        <translation>in Realisierung %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von %1</translation>
    </message>
    <message>
        <source>p. 1, abstract</source>
        <translation>S. 1, Zusammenfassung</translation>
    </message>
    <message>
        <source>p. 1, abstract; p. 4, conclusion</source>
        <translation>S. 1, Zusammenfassung; S. 4, Schluss</translation>
    </message>
    <message>
        <source>p. 1, definitions of h and of the rms gradient</source>
        <translation>S. 1, Definitionen von h und der RMS-Steigung</translation>
    </message>
    <message>
        <source>p. 2, Fig. 2; abstract</source>
        <translation>S. 2, Abb. 2; Zusammenfassung</translation>
    </message>
    <message>
        <source>p. 2, Figs. 3 and 4</source>
        <translation>S. 2, Abb. 3 und 4</translation>
    </message>
    <message>
        <source>p. 2, after Eq. (4)</source>
        <translation>S. 2, nach Gl. (4)</translation>
    </message>
    <message>
        <source>p. 2, before Eq. (5)</source>
        <translation>S. 2, vor Gl. (5)</translation>
    </message>
    <message>
        <source>p. 2, before Fig. 2</source>
        <translation>S. 2, vor Abb. 2</translation>
    </message>
    <message>
        <source>p. 3, after Eq. (14)</source>
        <translation>S. 3, nach Gl. (14)</translation>
    </message>
    <message>
        <source>p. 3, before Eq. (7)</source>
        <translation>S. 3, vor Gl. (7)</translation>
    </message>
    <message>
        <source>p. 4, after Eq. (15)</source>
        <translation>S. 4, nach Gl. (15)</translation>
    </message>
    <message>
        <source>p. 4, after Eq. (17)</source>
        <translation>S. 4, nach Gl. (17)</translation>
    </message>
    <message>
        <source>region %1</source>
        <translation>Bereich %1</translation>
    </message>
    <message>
        <source>region %1: %2 to %3 m/s</source>
        <translation>Bereich %1: %2 bis %3 m/s</translation>
    </message>
    <message>
        <source>row %1: column %2 is beyond %3 m</source>
        <translation>Zeile %1: Spalte %2 liegt jenseits von %3 m</translation>
    </message>
    <message>
        <source>row %1: column %2 is in &apos;%3&apos;; positions and heights are in metres</source>
        <translation>Zeile %1: Spalte %2 ist in „%3“; Orte und Höhen stehen in Metern</translation>
    </message>
    <message>
        <source>spacing %1 after data row %2 differs from %3; positions must be uniform to 1e-6</source>
        <translation>der Abstand %1 nach Datenzeile %2 unterscheidet sich von %3; die Orte müssen auf 1e-6 gleichabständig sein</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>text in UTF-16</source>
        <translation>Text in UTF-16</translation>
    </message>
    <message>
        <source>text in UTF-32</source>
        <translation>Text in UTF-32</translation>
    </message>
    <message>
        <source>text that is not JSON</source>
        <translation>Text, aber kein JSON</translation>
    </message>
    <message>
        <source>the force balance is not met %1: relative residual %2</source>
        <translation>das Kräftegleichgewicht ist %1 nicht erfüllt: relativer Rest %2</translation>
    </message>
    <message>
        <source>the indentation that carries %1 is sought</source>
        <translation>die Eindringung, die %1 trägt, wird gesucht</translation>
    </message>
    <message>
        <source>the paper&apos;s literal rule</source>
        <translation>die wörtliche Regel der Arbeit</translation>
    </message>
    <message>
        <source>this scene: %1</source>
        <translation>diese Szene: %1</translation>
    </message>
    <message>
        <source>this surface has one line, and no other realization</source>
        <translation>diese Oberfläche hat eine Linie und keine weitere Realisierung</translation>
    </message>
    <message>
        <source>unknown key; &apos;asperity check --help keys&apos; lists all</source>
        <translation>unbekannter Schlüssel; &apos;asperity check --help keys&apos; nennt alle</translation>
    </message>
    <message>
        <source>waves longer than %1 are all equally strong</source>
        <translation>Wellen über %1 sind alle gleich stark</translation>
    </message>
    <message>
        <source>A name for the scene, shown above its pictures.</source>
        <translation>Name der Szene; er steht über ihren Bildern.</translation>
    </message>
    <message>
        <source>First constant of the shift with temperature (Williams, Landel and Ferry).</source>
        <translation>Erste Konstante der Temperaturverschiebung (Williams, Landel und Ferry).</translation>
    </message>
    <message>
        <source>First velocity of the friction curve.</source>
        <translation>Erste Geschwindigkeit der Reibungskurve.</translation>
    </message>
    <message>
        <source>Force that presses one period of the line into the elastomer.</source>
        <translation>Kraft, die eine Periode der Linie in das Elastomer drückt.</translation>
    </message>
    <message>
        <source>Height of the sine's crests above its mean.</source>
        <translation>Höhe der Sinuskämme über dem Mittel.</translation>
    </message>
    <message>
        <source>How the elastomer responds to deformation.</source>
        <translation>Wie das Elastomer auf Verformung antwortet.</translation>
    </message>
    <message>
        <source>How the line is resolved: the paper's single elements (nodal), straight segments (linear) or smooth ones (cubic).</source>
        <translation>Wie die Linie aufgelöst wird: mit den einzelnen Elementen der Arbeit (nodal), mit geraden (linear) oder glatten Abschnitten (kubisch).</translation>
    </message>
    <message>
        <source>How the line moves.</source>
        <translation>Wie sich die Linie bewegt.</translation>
    </message>
    <message>
        <source>How the roughness grows with length: 0 is rough at every scale alike, with steep slopes; 1 is smooth at short ones.</source>
        <translation>Wie die Rauheit mit der Länge wächst: 0 ist auf jeder Skala gleich rau, mit steilen Steigungen; 1 ist auf kurzen Skalen glatt.</translation>
    </message>
    <message>
        <source>Hurst exponent</source>
        <translation>Hurst-Exponent</translation>
    </message>
    <message>
        <source>Indentation, measured from the lowest point of the line.</source>
        <translation>Eindringung, gemessen vom tiefsten Punkt der Linie.</translation>
    </message>
    <message>
        <source>Last velocity of the friction curve.</source>
        <translation>Letzte Geschwindigkeit der Reibungskurve.</translation>
    </message>
    <message>
        <source>Local coefficient of friction in contact, added to the friction of deformation and reported separately; 0: none.</source>
        <translation>Lokale Reibungszahl im Kontakt; sie kommt zum Verformungsanteil hinzu und wird getrennt ausgewiesen; 0: keine.</translation>
    </message>
    <message>
        <source>Viscosity of a dashpot beside the arms; 0: none.</source>
        <translation>Viskosität eines Dämpfers neben den Armen; 0: keiner.</translation>
    </message>
    <message>
        <source>Temperature of the elastomer; it shifts all relaxation times together.</source>
        <translation>Temperatur des Elastomers; sie verschiebt alle Relaxationszeiten gemeinsam.</translation>
    </message>
    <message>
        <source>Amplitude of the velocity about its mean: v = mean velocity + velocity amplitude sin(2 pi frequency t).</source>
        <translation>Amplitude der Geschwindigkeit um ihr Mittel: v = mittlere Geschwindigkeit + Geschwindigkeitsamplitude · sin(2π · Frequenz · t).</translation>
    </message>
    <message>
        <source>Oscillations of the velocity in a second.</source>
        <translation>Schwingungen der Geschwindigkeit je Sekunde.</translation>
    </message>
    <message>
        <source>Picks the random phases of the line.</source>
        <translation>Bestimmt die Zufallsphasen der Linie.</translation>
    </message>
    <message>
        <source>Points that resolve the line per element; 0: chosen, for a single line and for the mean over many, and files name the number used.</source>
        <translation>Stützpunkte der Linie je Element; 0: gewählt, für eine einzelne Linie und für das Mittel über viele; Dateien nennen die verwendete Zahl.</translation>
    </message>
    <message>
        <source>Radius of curvature at the parabola's vertex.</source>
        <translation>Krümmungsradius im Scheitel der Parabel.</translation>
    </message>
    <message>
        <source>Relative error of friction to be reached at every velocity: resolution and number of lines are then chosen by the program; 0: as scheme and realizations say.</source>
        <translation>Relativer Fehler der Reibungszahl, der bei jeder Geschwindigkeit zu erreichen ist: Auflösung und Anzahl der Linien wählt dann das Programm; 0: nach Verfahren und Realisierungen.</translation>
    </message>
    <message>
        <source>How rough the line is: root mean square of the height (ISO Rq), set by the long waves.</source>
        <translation>Wie rau die Linie ist: quadratischer Mittelwert der Höhe (ISO Rq), bestimmt von den langen Wellen.</translation>
    </message>
    <message>
        <source>Second constant of the shift with temperature (Williams, Landel and Ferry).</source>
        <translation>Zweite Konstante der Verschiebung mit der Temperatur (Williams, Landel und Ferry).</translation>
    </message>
    <message>
        <source>Shear modulus that is left when all arms have relaxed: how stiff the elastomer is at rest; steady sliding needs more than 0.</source>
        <translation>Schubmodul, der bleibt, wenn alle Arme relaxiert sind: wie steif das Elastomer in Ruhe ist; stationäres Gleiten braucht mehr als 0.</translation>
    </message>
    <message>
        <source>Short waves stronger on the summits, which touch first (above 0), or in the valleys (below 0); 0: everywhere alike.</source>
        <translation>Kurze Wellen stärker auf den Gipfeln, die zuerst Kontakt haben (über 0), oder in den Tälern (unter 0); 0: überall gleich.</translation>
    </message>
    <message>
        <source>Sine waves in one period of the line.</source>
        <translation>Sinuswellen in einer Periode der Linie.</translation>
    </message>
    <message>
        <source>The speed of the line: how fast or slowly it slides; of an oscillation the mean velocity.</source>
        <translation>Wie schnell oder langsam die Linie gleitet; bei einer Schwingung die mittlere Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Slope of the wedge's two sides.</source>
        <translation>Steigung der beiden Flanken des Keils.</translation>
    </message>
    <message>
        <source>Springs and dashpots in series: modulus in Pa and relaxation time in s of each; a standard solid has one.</source>
        <translation>Federn und Dämpfer in Reihe: je ein Modul in Pa und eine Relaxationszeit in s; ein Standardkörper hat einen solchen Arm.</translation>
    </message>
    <message>
        <source>Static shear modulus: how stiff or soft the elastomer is.</source>
        <translation>Statischer Schubmodul: wie steif oder weich (hart) das Elastomer ist.</translation>
    </message>
    <message>
        <source>Tangential load on each length in contact, instead of a local coefficient of friction; 0: none.</source>
        <translation>Tangentiallast je Länge im Kontakt, anstelle einer lokalen Reibungszahl; 0: keine.</translation>
    </message>
    <message>
        <source>Temperature at which the relaxation times are as given.</source>
        <translation>Temperatur, für die die Relaxationszeiten angegeben sind.</translation>
    </message>
    <message>
        <source>The group of scenes that it belongs to.</source>
        <translation>Die Gruppe von Szenen, zu der sie gehört.</translation>
    </message>
    <message>
        <source>The shape of the rigid line.</source>
        <translation>Form der starren Linie.</translation>
    </message>
    <message>
        <source>Time that the motion takes; a step or a reversal comes at half of it.</source>
        <translation>Dauer der Bewegung; ein Sprung oder eine Umkehr kommt nach der Hälfte.</translation>
    </message>
    <message>
        <source>Velocity from half of the duration on; below 0 the line goes back.</source>
        <translation>Geschwindigkeit ab der Hälfte der Dauer; unter 0 läuft die Linie zurück.</translation>
    </message>
    <message>
        <source>Viscosity over shear modulus: how long the free surface takes to recover.</source>
        <translation>Viskosität durch Schubmodul: wie lange die freie Oberfläche braucht, um sich zu erholen.</translation>
    </message>
    <message>
        <source>Waves longer than this are all equally strong; 0: the roughness is self-affine up to the whole period.</source>
        <translation>Längere Wellen als diese sind alle gleich stark; 0: Die Rauheit ist bis zur vollen Periode selbstaffin.</translation>
    </message>
    <message>
        <source>What to look for in the scene.</source>
        <translation>Worauf in der Szene zu achten ist.</translation>
    </message>
    <message>
        <source>amplitude</source>
        <translation>Amplitude</translation>
    </message>
    <message>
        <source>velocity amplitude</source>
        <translation>Amplitude der Geschwindigkeit</translation>
    </message>
    <message>
        <source>mean velocity</source>
        <translation>mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>arms</source>
        <translation>Arme</translation>
    </message>
    <message>
        <source>chapter</source>
        <translation>Kapitel</translation>
    </message>
    <message>
        <source>cubic</source>
        <translation>kubisch</translation>
    </message>
    <message>
        <source>description</source>
        <translation>Beschreibung</translation>
    </message>
    <message>
        <source>duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>elastic</source>
        <translation>elastisch</translation>
    </message>
    <message>
        <source>elements</source>
        <translation>Elemente</translation>
    </message>
    <message>
        <source>highest velocity</source>
        <translation>größte Geschwindigkeit</translation>
    </message>
    <message>
        <source>force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>frequency</source>
        <translation>Frequenz</translation>
    </message>
    <message>
        <source>indentation</source>
        <translation>Eindringung</translation>
    </message>
    <message>
        <source>kelvin</source>
        <translation>Kelvin</translation>
    </message>
    <message>
        <source>kind of line</source>
        <translation>Art der Linie</translation>
    </message>
    <message>
        <source>period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>local friction</source>
        <translation>lokale Reibung</translation>
    </message>
    <message>
        <source>local shear</source>
        <translation>lokaler Schub</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>nodal</source>
        <translation>nodal</translation>
    </message>
    <message>
        <source>normal force</source>
        <translation>Normalkraft</translation>
    </message>
    <message>
        <source>oscillation</source>
        <translation>Schwingung</translation>
    </message>
    <message>
        <source>oversampling</source>
        <translation>Überabtastung</translation>
    </message>
    <message>
        <source>parabola</source>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>Profil</translation>
    </message>
    <message>
        <source>prony</source>
        <translation>Prony</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>realizations</source>
        <translation>Realisierungen</translation>
    </message>
    <message>
        <source>relaxation time</source>
        <translation>Relaxationszeit</translation>
    </message>
    <message>
        <source>equilibrium modulus</source>
        <translation>Gleichgewichtsmodul</translation>
    </message>
    <message>
        <source>instantaneous modulus</source>
        <translation>Momentanmodul</translation>
    </message>
    <message>
        <source>reversal</source>
        <translation>Umkehr</translation>
    </message>
    <message>
        <source>rheology</source>
        <translation>Rheologie</translation>
    </message>
    <message>
        <source>rms height</source>
        <translation>RMS-Höhe</translation>
    </message>
    <message>
        <source>roll-off</source>
        <translation>Roll-off</translation>
    </message>
    <message>
        <source>scheme</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>self-affine</source>
        <translation>selbstaffin</translation>
    </message>
    <message>
        <source>shear modulus</source>
        <translation>Schubmodul</translation>
    </message>
    <message>
        <source>constant C1</source>
        <translation>Konstante C1</translation>
    </message>
    <message>
        <source>constant C2</source>
        <translation>Konstante C2</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>lowest velocity</source>
        <translation>kleinste Geschwindigkeit</translation>
    </message>
    <message>
        <source>standard-solid</source>
        <translation>Standardkörper</translation>
    </message>
    <message>
        <source>start</source>
        <translation>Anfahren</translation>
    </message>
    <message>
        <source>steady</source>
        <translation>stationär</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Sprung</translation>
    </message>
    <message>
        <source>target error</source>
        <translation>Zielfehler</translation>
    </message>
    <message>
        <source>temperature</source>
        <translation>Temperatur</translation>
    </message>
    <message>
        <source>title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>velocity after</source>
        <translation>danach</translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>waves</source>
        <translation>Wellen</translation>
    </message>
    <message>
        <source>wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>%1 internal variables an element</source>
        <translation>%1 innere Variablen je Element</translation>
    </message>
    <message>
        <source>as many random lines as the target accuracy needs</source>
        <translation>so viele zufällige Linien, wie die verlangte Genauigkeit braucht</translation>
    </message>
    <message>
        <source>%1 random lines</source>
        <translation>%1 Zufallslinien</translation>
    </message>
    <message>
        <source>%1 velocities, side by side where the kernel can</source>
        <translation>%1 Geschwindigkeiten, nebeneinander, wo der Rechenkern es kann</translation>
    </message>
    <message>
        <source>a free surface recovers with one relaxation time</source>
        <translation>eine freie Oberfläche erholt sich mit einer Relaxationszeit</translation>
    </message>
    <message>
        <source>a free surface recovers with several relaxation times</source>
        <translation>eine freie Oberfläche erholt sich mit mehreren Relaxationszeiten</translation>
    </message>
    <message>
        <source>a local coefficient of %1 is reported separately</source>
        <translation>eine lokale Reibungszahl von %1 wird getrennt ausgewiesen</translation>
    </message>
    <message>
        <source>arms must be after a period as they were before</source>
        <translation>die Arme müssen nach einer Periode sein wie zuvor</translation>
    </message>
    <message>
        <source>averaging</source>
        <translation>Mittelung</translation>
    </message>
    <message>
        <source>periodicity</source>
        <translation>Periodizität</translation>
    </message>
    <message>
        <source>force balance</source>
        <translation>Kräftegleichgewicht</translation>
    </message>
    <message>
        <source>free surface</source>
        <translation>freie Oberfläche</translation>
    </message>
    <message>
        <source>interface friction</source>
        <translation>Grenzflächenreibung</translation>
    </message>
    <message>
        <source>it is drawn, or marched on from</source>
        <translation>sie wird gezeichnet oder dient als Ausgangszustand</translation>
    </message>
    <message>
        <source>line</source>
        <translation>Linie</translation>
    </message>
    <message>
        <source>local friction has no strength</source>
        <translation>die lokale Reibung ist null</translation>
    </message>
    <message>
        <source>no arm has strength and time</source>
        <translation>kein Arm hat Modul und Zeit</translation>
    </message>
    <message>
        <source>no wave of the line is longer than the roll-off</source>
        <translation>keine Welle der Linie ist länger als der Roll-off</translation>
    </message>
    <message>
        <source>nothing is drawn</source>
        <translation>es wird nichts gezeichnet</translation>
    </message>
    <message>
        <source>nothing relaxes</source>
        <translation>es relaxiert nichts</translation>
    </message>
    <message>
        <source>one line is enough</source>
        <translation>eine Linie genügt</translation>
    </message>
    <message>
        <source>only one velocity is asked for</source>
        <translation>nur eine Geschwindigkeit ist gefragt</translation>
    </message>
    <message>
        <source>only the line is asked for</source>
        <translation>nur die Linie ist gefragt</translation>
    </message>
    <message>
        <source>phases alone are random: summits are as rough as valleys</source>
        <translation>nur die Phasen sind zufällig: Gipfel sind so rau wie Täler</translation>
    </message>
    <message>
        <source>short waves are stronger in the valleys, kappa = %1</source>
        <translation>kurze Wellen sind in den Tälern stärker, κ = %1</translation>
    </message>
    <message>
        <source>short waves are stronger on the summits, kappa = %1</source>
        <translation>kurze Wellen sind auf den Gipfeln stärker, κ = %1</translation>
    </message>
    <message>
        <source>start from rest</source>
        <translation>Anfahren aus der Ruhe</translation>
    </message>
    <message>
        <source>steady pass</source>
        <translation>stationärer Durchlauf</translation>
    </message>
    <message>
        <source>steady sliding is stationary in the line's frame</source>
        <translation>stationäres Gleiten ändert sich im Bezugssystem der Linie nicht</translation>
    </message>
    <message>
        <source>stored shape</source>
        <translation>gespeicherte Form</translation>
    </message>
    <message>
        <source>summit correlation</source>
        <translation>Gipfelkorrelation</translation>
    </message>
    <message>
        <source>temperature shift</source>
        <translation>Temperaturverschiebung</translation>
    </message>
    <message>
        <source>the elastomer has none</source>
        <translation>das Elastomer hat keine</translation>
    </message>
    <message>
        <source>the elastomer is at its reference temperature</source>
        <translation>das Elastomer hat seine Bezugstemperatur</translation>
    </message>
    <message>
        <source>the elastomer is elastic and responds at once</source>
        <translation>das Elastomer ist elastisch und antwortet sofort</translation>
    </message>
    <message>
        <source>the indentation is given</source>
        <translation>die Eindringung ist vorgegeben</translation>
    </message>
    <message>
        <source>the line has no spectrum of its own</source>
        <translation>die Linie hat kein eigenes Spektrum</translation>
    </message>
    <message>
        <source>the line is given by a formula</source>
        <translation>die Linie ist durch eine Formel gegeben</translation>
    </message>
    <message>
        <source>the line is not random</source>
        <translation>die Linie ist nicht zufällig</translation>
    </message>
    <message>
        <source>the line is pressed in at v = 0 and everything has relaxed</source>
        <translation>die Linie ist bei v = 0 eingedrückt, und alles ist relaxiert</translation>
    </message>
    <message>
        <source>the lowest point is always in contact: the period closes in one pass</source>
        <translation>der tiefste Punkt ist immer in Kontakt: Die Periode schließt sich in einem Durchlauf</translation>
    </message>
    <message>
        <source>the motion begins at v = 0, where nothing slides</source>
        <translation>die Bewegung beginnt bei v = 0, wo nichts gleitet</translation>
    </message>
    <message>
        <source>the motion does not begin from rest</source>
        <translation>die Bewegung beginnt nicht in Ruhe</translation>
    </message>
    <message>
        <source>the profile is read and taken as one period of a band-limited line</source>
        <translation>das Profil wird gelesen und gilt als eine Periode einer bandbegrenzten Linie</translation>
    </message>
    <message>
        <source>the spectrum is self-affine up to the whole period</source>
        <translation>das Spektrum ist bis zur vollen Periode selbstaffin</translation>
    </message>
    <message>
        <source>the steady state at the first velocity is where the motion begins</source>
        <translation>die Bewegung beginnt im stationären Zustand der ersten Geschwindigkeit</translation>
    </message>
    <message>
        <source>the velocity changes with time</source>
        <translation>die Geschwindigkeit ändert sich mit der Zeit</translation>
    </message>
    <message>
        <source>the window lets the line pass by</source>
        <translation>das Fenster lässt die Linie vorbeiziehen</translation>
    </message>
    <message>
        <source>there is no steady state</source>
        <translation>es gibt keinen stationären Zustand</translation>
    </message>
    <message>
        <source>time march</source>
        <translation>Zeitschritte</translation>
    </message>
    <message>
        <source>velocity sweep</source>
        <translation>Geschwindigkeitsreihe</translation>
    </message>
    <message>
        <source>waves of a self-affine spectrum with random phases are summed</source>
        <translation>Wellen eines selbstaffinen Spektrums mit Zufallsphasen werden summiert</translation>
    </message>
    <message>
        <source>0 by the literal rule</source>
        <translation>0 nach der wörtlichen Regel</translation>
    </message>
    <message>
        <source>0.7 to 1.3 decades</source>
        <translation>0,7 bis 1,3 Dekaden</translation>
    </message>
    <message>
        <source>%1 °C</source>
        <translation>%1 °C</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>H = %1: %2 %</source>
        <translation>H = %1: %2 %</translation>
    </message>
    <message>
        <source>H = %1: %2</source>
        <translation>H = %1: %2</translation>
    </message>
    <message>
        <source>H = %1: %2 for %3</source>
        <translation>H = %1: %2 bei Theorie %3</translation>
    </message>
    <message>
        <source>%1 realizations</source>
        <translation>%1 Realisierungen</translation>
    </message>
    <message>
        <source>At first the coefficient of friction increases linearly with velocity (region I)</source>
        <translation>Zunächst wächst die Reibungszahl linear mit der Geschwindigkeit (Bereich I)</translation>
    </message>
    <message>
        <source>At high forces the decreasing region IV is outside the scope of practical velocities</source>
        <translation>Bei großen Kräften liegt der fallende Bereich IV jenseits praktischer Geschwindigkeiten</translation>
    </message>
    <message>
        <source>At low velocities μ is 4 η v / Fₙ times the contact length and the squared rms slope in contact</source>
        <translation>Bei kleinen Geschwindigkeiten ist μ gleich 4 η v / Fₙ mal Kontaktlänge und Quadrat der RMS-Steigung im Kontakt</translation>
    </message>
    <message>
        <source>At low velocities the coefficient of friction is very accurately proportional to the squared rms gradient, varied by the spacing</source>
        <translation>Bei kleinen Geschwindigkeiten ist die Reibungszahl sehr genau proportional zum Quadrat der RMS-Steigung, die über den Abstand variiert wird</translation>
    </message>
    <message>
        <source>At small forces the contact length is a power of the force, with the exponent 1/(1+H)</source>
        <translation>Bei kleinen Kräften ist die Kontaktlänge eine Potenz der Kraft mit dem Exponenten 1/(1+H)</translation>
    </message>
    <message>
        <source>At small velocities the coefficient of friction increases linearly with velocity, for six Hurst exponents</source>
        <translation>Bei kleinen Geschwindigkeiten wächst die Reibungszahl linear mit der Geschwindigkeit, für sechs Hurst-Exponenten</translation>
    </message>
    <message>
        <source>At the same number of elements; it is a third variable, by the spacing.</source>
        <translation>Bei gleicher Anzahl der Elemente; sie ist über den Abstand eine dritte Variable.</translation>
    </message>
    <message>
        <source>Before the shift it is %1 decades.</source>
        <translation>Vor der Verschiebung sind es %1 Dekaden.</translation>
    </message>
    <message>
        <source>Changing force, system size or relaxation time only shifts the curves in the double logarithmic presentation</source>
        <translation>Eine Änderung von Kraft, Systemgröße oder Relaxationszeit verschiebt die Kurven in der doppeltlogarithmischen Darstellung nur</translation>
    </message>
    <message>
        <source>Contact of a rough line and a viscoelastic elastomer</source>
        <translation>Kontakt einer rauen Linie mit einem viskoelastischen Elastomer</translation>
    </message>
    <message>
        <source>Curves are shifted by changes of temperature, which influences the relaxation time (the master curve procedure)</source>
        <translation>Kurven werden durch Änderung der Temperatur verschoben, die die Relaxationszeit beeinflusst (Masterkurvenverfahren)</translation>
    </message>
    <message>
        <source>Dependence on velocity for six Hurst exponents</source>
        <translation>Geschwindigkeitsabhängigkeit für sechs Hurst-Exponenten</translation>
    </message>
    <message>
        <source>Dependence on velocity for twenty normal forces</source>
        <translation>Geschwindigkeitsabhängigkeit für zwanzig Normalkräfte</translation>
    </message>
    <message>
        <source>Elements out of contact satisfy u &lt; z - d, those in contact f &gt; 0</source>
        <translation>Elemente außer Kontakt erfüllen u &lt; z - d, solche in Kontakt f &gt; 0</translation>
    </message>
    <message>
        <source>Eq. (11)</source>
        <translation>Gl. (11)</translation>
    </message>
    <message>
        <source>Eq. (11) can be rewritten as Eq. (12), in which β does not appear</source>
        <translation>Gl. (11) lässt sich als Gl. (12) schreiben, in der β nicht vorkommt</translation>
    </message>
    <message>
        <source>Eq. (11) interpolates between regions I, II and III; its quality can be seen in Fig. 3</source>
        <translation>Gl. (11) interpoliert zwischen den Bereichen I, II und III; ihre Güte zeigt Abb. 3</translation>
    </message>
    <message>
        <source>Fₙ / G h L of about 1 gives the order of magnitude of the force of complete contact</source>
        <translation>Fₙ / G h L von etwa 1 gibt die Größenordnung der Kraft für Vollkontakt an</translation>
    </message>
    <message>
        <source>For 0.2 &lt; H &lt; 0.8 and not too small forces the plateau is almost constant, about √2 times the rms slope</source>
        <translation>Für 0,2 &lt; H &lt; 0,8 und nicht zu kleine Kräfte ist das Plateau fast konstant, etwa √2 mal die RMS-Steigung</translation>
    </message>
    <message>
        <source>For 0.2 &lt; H &lt; 0.8 the exponent α = H/(1 + H) fits the numerical data very well</source>
        <translation>Für 0,2 &lt; H &lt; 0,8 passt der Exponent α = H/(1 + H) sehr gut zu den numerischen Daten</translation>
    </message>
    <message>
        <source>For separate elements Fₙ(d) jumps where an element enters; see Fig. 2's claims.</source>
        <translation>Bei getrennten Elementen springt Fₙ(d), wo ein Element eintritt; siehe die Aussagen zu Abb. 2.</translation>
    </message>
    <message>
        <source>Friction finally drops to another constant level (region IV)</source>
        <translation>Die Reibung fällt schließlich auf ein anderes konstantes Niveau (Bereich IV)</translation>
    </message>
    <message>
        <source>Friction on the plateau over the normal force</source>
        <translation>Reibung auf dem Plateau über der Normalkraft</translation>
    </message>
    <message>
        <source>Hurst exponent H</source>
        <translation>Hurst-Exponent H</translation>
    </message>
    <message>
        <source>In complete contact μ = 4 L η grad² v / Fₙ, exactly confirmed</source>
        <translation>Im Vollkontakt ist μ = 4 L η grad² v / Fₙ, exakt bestätigt</translation>
    </message>
    <message>
        <source>In zone 1 the coefficient of friction is a power of the force, with exponent −H/(1 + H)</source>
        <translation>In Zone 1 ist die Reibungszahl eine Potenz der Kraft mit dem Exponenten −H/(1 + H)</translation>
    </message>
    <message>
        <source>Largest at H = %1.</source>
        <translation>Am größten bei H = %1.</translation>
    </message>
    <message>
        <source>On the plateau (region III) μ is about √2 times the rms slope</source>
        <translation>Auf dem Plateau (Bereich III) ist μ etwa √2 mal die RMS-Steigung</translation>
    </message>
    <message>
        <source>On the plateau the coefficient of friction depends only weakly on the Hurst exponent</source>
        <translation>Auf dem Plateau hängt die Reibungszahl nur schwach vom Hurst-Exponenten ab</translation>
    </message>
    <message>
        <source>few contacts carry the load</source>
        <translation>wenige Kontakte tragen die Last</translation>
    </message>
    <message>
        <source>Few contacts of the finite period carry the load, and the slope in contact falls, Eq. (15). Begins below 95 % of the maximum.</source>
        <translation>Wenige Kontakte der endlichen Periode tragen die Last, und die Steigung im Kontakt fällt, Gl. (15). Beginnt unter 95 % des Maximums.</translation>
    </message>
    <message>
        <source>Tinted: Fₙ/(4ηv) is below 0.1 h (η: viscosity). It is the sum of the heights climbed by all contacts of one period; the border moves with the period L.</source>
        <translation>Getönt: Fₙ/(4ηv) liegt unter 0,1 h (η: Viskosität). Es ist die Summe der Höhen, die alle Kontakte einer Periode erklimmen; die Grenze wandert mit der Periode L.</translation>
    </message>
    <message>
        <source>p. 3, after Eq. (9)</source>
        <translation>S. 3, nach Gl. (9)</translation>
    </message>
    <message>
        <source>p. 4, Eqs. (9) and (15)</source>
        <translation>S. 4, Gln. (9) und (15)</translation>
    </message>
    <message>
        <source>p. 1, abstract; p. 4, Eq. (17)</source>
        <translation>S. 1, Zusammenfassung; S. 4, Gl. (17)</translation>
    </message>
    <message>
        <source>In the plateau region the elastomer behaves practically as a viscous fluid: the elasticity does not play any role</source>
        <translation>Auf dem Plateau verhält sich das Elastomer praktisch wie eine zähe Flüssigkeit: Die Elastizität spielt keine Rolle</translation>
    </message>
    <message>
        <source>part of the normal force that the springs carry at the maximum of the curve</source>
        <translation>Anteil der Normalkraft, den die Federn im Maximum der Kurve tragen</translation>
    </message>
    <message>
        <source>The trailing sides of the summits carry %1 % of it there.</source>
        <translation>Die ablaufenden Seiten der Gipfel tragen dort %1 % von ihr.</translation>
    </message>
    <message>
        <source>The decrease at large velocities (region IV) is related to the dependence of the rms slope on the size of the real contact</source>
        <translation>Die Abnahme bei großen Geschwindigkeiten (Bereich IV) hängt mit der Abhängigkeit der quadratisch gemittelten Steigung von der Größe des wahren Kontakts zusammen</translation>
    </message>
    <message>
        <source>μ / slope in contact at the highest velocity over that at the maximum, mean over the lines of each</source>
        <translation>μ / Steigung im Kontakt bei der höchsten Geschwindigkeit, bezogen auf den Wert im Maximum; jeweils über die Linien gemittelt</translation>
    </message>
    <message>
        <source>The plateau decreases where the contact becomes extremely small, at extremely high sliding velocities or extremely low normal forces</source>
        <translation>Das Plateau nimmt ab, wo der Kontakt äußerst klein wird: bei äußerst hohen Geschwindigkeiten oder äußerst kleinen Normalkräften</translation>
    </message>
    <message>
        <source>Fₙ / (4 η v) over h where region IV begins, geometric mean over four forces and three periods</source>
        <translation>Fₙ / (4 η v), bezogen auf h, wo Bereich IV beginnt; geometrisches Mittel über vier Kräfte und drei Perioden</translation>
    </message>
    <message>
        <source>0.03 to 0.3: the sum of the heights climbed by all contacts of one period is about a tenth of h</source>
        <translation>0,03 bis 0,3: Die Summe der Höhen, die alle Kontakte einer Periode erklimmen, ist etwa ein Zehntel von h</translation>
    </message>
    <message>
        <source>The law of friction depends on the size of the system, which shifts the curves</source>
        <translation>Das Reibungsgesetz hängt von der Größe des Systems ab, die die Kurven verschiebt</translation>
    </message>
    <message>
        <source>exponent n of v ∝ Lⁿ where region IV begins, at given Fₙ / L, h and roll-off</source>
        <translation>Exponent n von v ∝ Lⁿ, wo Bereich IV beginnt, bei gleichem Fₙ / L, h und gleicher Abflachung</translation>
    </message>
    <message>
        <source>0.5 to 1.5; 1 by Fₙ / (4 η v) = 0.1 h</source>
        <translation>0,5 bis 1,5; 1 nach Fₙ / (4 η v) = 0,1 h</translation>
    </message>
    <message>
        <source>Fine steps of the same N elements are not resolved by %1 per spacing.</source>
        <translation>Feine Schritte derselben N Elemente sind mit %1 je Abstand nicht aufgelöst.</translation>
    </message>
    <message>
        <source>Fₙ/GhL = %1.</source>
        <translation>Fₙ/GhL = %1.</translation>
    </message>
    <message>
        <source>largest |α - H/(1 + H)| at the five Hurst exponents between 0.2 and 0.8, without the ends; Fₙ / G h L from 0.001 to 0.1</source>
        <translation>größtes |α - H/(1 + H)| an den fünf Hurst-Exponenten zwischen 0,2 und 0,8, ohne die Enden; Fₙ / G h L von 0,001 bis 0,1</translation>
    </message>
    <message>
        <source>The points share their random lines and are correlated: neighbours in α by %1 on average.</source>
        <translation>Die Punkte haben die Zufallslinien gemeinsam und sind korreliert: Nachbarn in α im Mittel mit %1.</translation>
    </message>
    <message>
        <source>The points share their random lines and are correlated.</source>
        <translation>Die Punkte haben die Zufallslinien gemeinsam und sind korreliert.</translation>
    </message>
    <message>
        <source>β most distant from 1 at the eleven Hurst exponents</source>
        <translation>das am weitesten von 1 entfernte β an den elf Hurst-Exponenten</translation>
    </message>
    <message>
        <source>exponent of μ over Fₙ at the lowest velocity, Fₙ / G h L up to 0.1</source>
        <translation>Exponent von μ über Fₙ bei der kleinsten Geschwindigkeit, Fₙ / G h L bis 0,1</translation>
    </message>
    <message>
        <source>exponent of the contact length over Fₙ at the lowest velocity, Fₙ / G h L up to 0.1</source>
        <translation>Exponent der Kontaktlänge über Fₙ bei der kleinsten Geschwindigkeit, Fₙ / G h L bis 0,1</translation>
    </message>
    <message>
        <source>For a surface that is rougher on the summits than on the slopes the rms slope would decrease with indentation</source>
        <translation>Bei einer Oberfläche, die auf den Gipfeln rauer ist als an den Hängen, nähme die quadratisch gemittelte Steigung mit der Eindringung ab</translation>
    </message>
    <message>
        <source>rms slope in contact at the smallest force over that at the largest, with a summit correlation of 2</source>
        <translation>quadratisch gemittelte Steigung im Kontakt bei der kleinsten Kraft, bezogen auf die bei der größten, mit einer Gipfelkorrelation von 2</translation>
    </message>
    <message>
        <source>With a summit correlation of %1 it is %2.</source>
        <translation>Mit einer Gipfelkorrelation von %1 ist sie %2.</translation>
    </message>
    <message>
        <source>Dimensionless velocity of about 1 gives the order of magnitude of the velocity at which the elastomer is detached on the trailing side of any asperity and all the contacts become one-sided</source>
        <translation>Eine dimensionslose Geschwindigkeit von etwa 1 gibt die Größenordnung der Geschwindigkeit, bei der sich das Elastomer an der ablaufenden Seite jeder Unebenheit ablöst und alle Kontakte einseitig werden</translation>
    </message>
    <message>
        <source>dimensionless velocity at which trailing sides carry a tenth of the load, Fₙ / G h L = 0.01, 0.1 and 1: the most distant</source>
        <translation>dimensionslose Geschwindigkeit, bei der ablaufende Seiten ein Zehntel der Last tragen, Fₙ / G h L = 0,01, 0,1 und 1: die entfernteste</translation>
    </message>
    <message>
        <source>Fₙ / G h L at which 90 % of the line are in contact, at the lowest velocity</source>
        <translation>Fₙ / G h L, bei dem 90 % der Linie im Kontakt sind, bei der kleinsten Geschwindigkeit</translation>
    </message>
    <message>
        <source>smallest over largest plateau of the six Hurst exponents, Fₙ / G h L near 10</source>
        <translation>kleinstes durch größtes Plateau der sechs Hurst-Exponenten, Fₙ / G h L nahe 10</translation>
    </message>
    <message>
        <source>Smallest at H = %1, largest at H = %2.</source>
        <translation>Am kleinsten bei H = %1, am größten bei H = %2.</translation>
    </message>
    <message>
        <source>Region II covers one decade of velocities</source>
        <translation>Bereich II umfasst eine Dekade der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Simulations with different rms gradients, varied by the spacing, show μ very accurately proportional to the squared gradient</source>
        <translation>Simulationen mit verschiedenen RMS-Steigungen, über den Abstand variiert, zeigen μ sehr genau proportional zum Quadrat der Steigung</translation>
    </message>
    <message>
        <source>The algorithm is not iterative and there are no convergence problems</source>
        <translation>Der Algorithmus ist nicht iterativ, und es gibt keine Konvergenzprobleme</translation>
    </message>
    <message>
        <source>The coefficient of friction depends on force and shear modulus only over Fₙ / G</source>
        <translation>Die Reibungszahl hängt von Kraft und Schubmodul nur über Fₙ / G ab</translation>
    </message>
    <message>
        <source>The coefficient of friction depends on two dimensionless combinations of force, velocity, modulus, viscosity, roughness, slope, size and the Hurst exponent</source>
        <translation>Die Reibungszahl hängt von zwei dimensionslosen Kombinationen aus Kraft, Geschwindigkeit, Modul, Viskosität, Rauheit, Steigung und Größe sowie vom Hurst-Exponenten ab</translation>
    </message>
    <message>
        <source>The coefficient of friction increases in region II by a factor of two</source>
        <translation>Die Reibungszahl wächst im Bereich II um den Faktor zwei</translation>
    </message>
    <message>
        <source>The coefficient of friction on the plateau depends only weakly on the normal force</source>
        <translation>Die Reibungszahl auf dem Plateau hängt nur schwach von der Normalkraft ab</translation>
    </message>
    <message>
        <source>The dependence of the slope in contact on force is less pronounced for H near 0 and gets stronger for H near 1</source>
        <translation>Die Abhängigkeit der Steigung im Kontakt von der Kraft ist für H nahe 0 schwächer und wird für H nahe 1 stärker</translation>
    </message>
    <message>
        <source>The form of the dependence is approximately the same for different forces, only shifted along the axis of log v</source>
        <translation>Die Form der Abhängigkeit ist für verschiedene Kräfte ungefähr dieselbe, nur längs der log-v-Achse verschoben</translation>
    </message>
    <message>
        <source>The indentation depth is determined to satisfy the condition of constant normal force</source>
        <translation>Die Eindringung wird so bestimmt, dass die Bedingung konstanter Normalkraft erfüllt ist</translation>
    </message>
    <message>
        <source>The master curve of Eqs. (16) and (17)</source>
        <translation>Die Masterkurve nach Gl. (16) und (17)</translation>
    </message>
    <message>
        <source>The maximum of the coefficient of friction in the medium range of velocities is proportional to the rms gradient</source>
        <translation>Das Maximum der Reibungszahl im mittleren Geschwindigkeitsbereich ist proportional zur RMS-Steigung</translation>
    </message>
    <message>
        <source>The plateau decreases at very small forces</source>
        <translation>Das Plateau nimmt bei sehr kleinen Kräften ab</translation>
    </message>
    <message>
        <source>The rms gradient is dominated by the short wavelengths</source>
        <translation>Die RMS-Steigung wird von den kurzen Wellenlängen bestimmt</translation>
    </message>
    <message>
        <source>The rms slope in contact increases with the indentation, weakly</source>
        <translation>Die RMS-Steigung im Kontakt wächst schwach mit der Eindringung</translation>
    </message>
    <message>
        <source>The slope in contact rises with the force, too, so that μ and the contact length need not have the same exponent up to 1.</source>
        <translation>Auch die Steigung im Kontakt wächst mit der Kraft, daher müssen μ und Kontaktlänge nicht bis 1 denselben Exponenten haben.</translation>
    </message>
    <message>
        <source>The spacing sets the shortest wave of the line and with it the rms slope: it acts as a parameter of the model.</source>
        <translation>Der Abstand legt die kürzeste Welle der Linie und damit die RMS-Steigung fest: Er wirkt als Parameter des Modells.</translation>
    </message>
    <message>
        <source>Typical dependence of friction on velocity</source>
        <translation>Typische Abhängigkeit der Reibung von der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Vertical and horizontal units differ.</source>
        <translation>Senkrechte und waagerechte Einheiten sind verschieden.</translation>
    </message>
    <message>
        <source>WLF shift of a filled rubber: C₁ = 4.41, C₂ = 137.64 K, Tᵣ = 343.15 K.</source>
        <translation>WLF-Verschiebung eines gefüllten Gummis: C₁ = 4,41; C₂ = 137,64 K; Tᵣ = 343,15 K.</translation>
    </message>
    <message>
        <source>What the spacing of the elements does</source>
        <translation>Was der Abstand der Elemente bewirkt</translation>
    </message>
    <message>
        <source>as computed</source>
        <translation>wie berechnet</translation>
    </message>
    <message>
        <source>as given</source>
        <translation>wie gegeben</translation>
    </message>
    <message>
        <source>at most 1e-12, and no negative pressure</source>
        <translation>höchstens 1e-12 und kein negativer Druck</translation>
    </message>
    <message>
        <source>below 0.02 at each</source>
        <translation>jeweils unter 0,02</translation>
    </message>
    <message>
        <source>below 0.05 decades (12 %)</source>
        <translation>unter 0,05 Dekaden (12 %)</translation>
    </message>
    <message>
        <source>below 0.1 (26 %)</source>
        <translation>unter 0,1 (26 %)</translation>
    </message>
    <message>
        <source>below 1e-9, on at least one point</source>
        <translation>unter 1e-9, an mindestens einem Punkt</translation>
    </message>
    <message>
        <source>coefficient of friction</source>
        <translation>Reibungszahl</translation>
    </message>
    <message>
        <source>decades from 80 % of the line through region I to 95 % of the maximum</source>
        <translation>Dekaden von 80 % der Geraden durch Bereich I bis 95 % des Maximums</translation>
    </message>
    <message>
        <source>every β within 0.1 of 1</source>
        <translation>jedes β höchstens 0,1 von 1 entfernt</translation>
    </message>
    <message>
        <source>exponent</source>
        <translation>Exponent</translation>
    </message>
    <message>
        <source>exponent n of μ ∝ gradⁿ at Fₙ / G h L = 0.1</source>
        <translation>Exponent n von μ ∝ gradⁿ bei Fₙ / G h L = 0,1</translation>
    </message>
    <message>
        <source>exponent n of μ ∝ gradⁿ at the lowest velocity, twenty spacings</source>
        <translation>Exponent n von μ ∝ gradⁿ bei der kleinsten Geschwindigkeit, zwanzig Abstände</translation>
    </message>
    <message>
        <source>exponent n of μ ∝ vⁿ</source>
        <translation>Exponent n von μ ∝ vⁿ</translation>
    </message>
    <message>
        <source>exponent n of μ ∝ vⁿ over the last decade, by the paper's literal rule</source>
        <translation>Exponent n von μ ∝ vⁿ über die letzte Dekade, nach der wörtlichen Regel der Arbeit</translation>
    </message>
    <message>
        <source>exponent n of the maximum ∝ gradⁿ, twenty spacings</source>
        <translation>Exponent n des Maximums ∝ gradⁿ, zwanzig Abstände</translation>
    </message>
    <message>
        <source>Mean of %1 lines.</source>
        <translation>Mittel aus %1 Linien.</translation>
    </message>
    <message>
        <source>Band: estimated error of elements and time steps, %1 in μ.</source>
        <translation>Band: geschätzter Fehler durch Elemente und Zeitschritte, %1 in μ.</translation>
    </message>
    <message>
        <source>friction μ, deformation alone</source>
        <translation>Reibung μ, nur Verformung</translation>
    </message>
    <message>
        <source>friction μ</source>
        <translation>Reibungszahl μ</translation>
    </message>
    <message>
        <source>h is dominated by the long wavelengths</source>
        <translation>h wird von den langen Wellenlängen bestimmt</translation>
    </message>
    <message>
        <source>largest change of μ / grad where h, L, G and τ change but Fₙ / G h L and τ v grad / h do not</source>
        <translation>größte Änderung von μ / grad, wenn sich h, L, G und τ ändern, aber Fₙ / G h L und τ v grad / h nicht</translation>
    </message>
    <message>
        <source>largest change of μ where both are tripled</source>
        <translation>größte Änderung von μ, wenn beide verdreifacht werden</translation>
    </message>
    <message>
        <source>largest distance of two curves (decades of μ), shifted together in region I, up to the plateau</source>
        <translation>größter Abstand zweier Kurven (Dekaden von μ), im Bereich I aufeinandergeschoben, bis zum Plateau</translation>
    </message>
    <message>
        <source>largest μ / rms slope of the line</source>
        <translation>größtes μ / RMS-Steigung der Linie</translation>
    </message>
    <message>
        <source>largest part of the steps in which no indentation meets the normal force</source>
        <translation>größter Anteil der Schritte, in denen keine Eindringung die Normalkraft trifft</translation>
    </message>
    <message>
        <source>largest penetration over the largest depth</source>
        <translation>größte Durchdringung durch größte Tiefe</translation>
    </message>
    <message>
        <source>largest |μ / Eq. (11) - 1| up to the maximum, β as measured</source>
        <translation>größtes |μ / Gl. (11) - 1| bis zum Maximum, β wie gemessen</translation>
    </message>
    <message>
        <source>largest |μ / Eq. (6) - 1| at the lowest velocity, all forces</source>
        <translation>größtes |μ / Gl. (6) - 1| bei der kleinsten Geschwindigkeit, alle Kräfte</translation>
    </message>
    <message>
        <source>largest |μ / Eq. (8) - 1| in complete contact, with the slope of the line as resolved</source>
        <translation>größtes |μ / Gl. (8) - 1| im Vollkontakt, mit der Steigung der aufgelösten Linie</translation>
    </message>
    <message>
        <source>largest |μ(v, T) / μ(v aₜ, Tᵣ) - 1|, 10 to 100 °C</source>
        <translation>größtes |μ(v, T) / μ(v aₜ, Tᵣ) - 1|, 10 bis 100 °C</translation>
    </message>
    <message>
        <source>largest |n - 1| of μ ∝ vⁿ over the five lowest velocities</source>
        <translation>größtes |n - 1| von μ ∝ vⁿ über die fünf kleinsten Geschwindigkeiten</translation>
    </message>
    <message>
        <source>linear or cubic (a resolved line)</source>
        <translation>linear oder kubisch (aufgelöste Linie)</translation>
    </message>
    <message>
        <source>literal (one spacing per step)</source>
        <translation>wörtlich (ein Abstand je Schritt)</translation>
    </message>
    <message>
        <source>measured, 0.001 ≤ Fₙ/GhL ≤ 0.1</source>
        <translation>gemessen, 0,001 ≤ Fₙ/GhL ≤ 0,1</translation>
    </message>
    <message>
        <source>measured, 0.001 ≤ Fₙ/GhL ≤ 1</source>
        <translation>gemessen, 0,001 ≤ Fₙ/GhL ≤ 1</translation>
    </message>
    <message>
        <source>more than half</source>
        <translation>mehr als die Hälfte</translation>
    </message>
    <message>
        <source>μ at the end of region II over μ at its start, borders as for its width</source>
        <translation>μ am Ende von Bereich II durch μ an seinem Anfang, Grenzen wie für seine Breite</translation>
    </message>
    <message>
        <source>normal force Fₙ</source>
        <translation>Normalkraft Fₙ</translation>
    </message>
    <message>
        <source>normalized friction μ/∇z</source>
        <translation>normierte Reibungszahl μ/∇z</translation>
    </message>
    <message>
        <source>over the rms slope</source>
        <translation>bezogen auf die RMS-Steigung</translation>
    </message>
    <message>
        <source>plateau at the smallest force over the largest plateau, mean over H</source>
        <translation>Plateau bei der kleinsten Kraft durch größtes Plateau, Mittel über H</translation>
    </message>
    <message>
        <source>plateau of μ / rms slope most distant from √2, Fₙ / G h L &gt;= 1</source>
        <translation>Plateau von μ / RMS-Steigung mit dem größten Abstand von √2, Fₙ / G h L &gt;= 1</translation>
    </message>
    <message>
        <source>plateau of μ/∇z</source>
        <translation>Plateau von μ/∇z</translation>
    </message>
    <message>
        <source>prefactor</source>
        <translation>Vorfaktor</translation>
    </message>
    <message>
        <source>relative residual of the force balance</source>
        <translation>relativer Rest des Kräftegleichgewichts</translation>
    </message>
    <message>
        <source>resolved line (%1 lines)</source>
        <translation>aufgelöste Linie (%1 Linien)</translation>
    </message>
    <message>
        <source>rms slope in contact at the smallest force over that at the largest</source>
        <translation>RMS-Steigung im Kontakt bei der kleinsten Kraft durch die bei der größten</translation>
    </message>
    <message>
        <source>rms spread of the shifted curves in decades of μ, up to the plateau</source>
        <translation>RMS-Streuung der verschobenen Kurven in Dekaden von μ, bis zum Plateau</translation>
    </message>
    <message>
        <source>share of h² from the longest decade of wavelengths</source>
        <translation>Anteil der längsten Dekade der Wellenlängen an h²</translation>
    </message>
    <message>
        <source>share of the squared gradient from the shortest decade of wavelengths</source>
        <translation>Anteil der kürzesten Dekade der Wellenlängen am Quadrat der Steigung</translation>
    </message>
    <message>
        <source>shifted by Eq. (17)</source>
        <translation>verschoben nach Gl. (17)</translation>
    </message>
    <message>
        <source>sliding velocity v</source>
        <translation>Gleitgeschwindigkeit v</translation>
    </message>
    <message>
        <source>smallest μ at the highest velocity over the maximum</source>
        <translation>kleinstes μ bei der höchsten Geschwindigkeit durch das Maximum</translation>
    </message>
    <message>
        <source>smallest over largest plateau, over five decades of force</source>
        <translation>kleinstes durch größtes Plateau, über fünf Dekaden der Kraft</translation>
    </message>
    <message>
        <source>spacing</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>table used by Eq. (11) here</source>
        <translation>hier für Gl. (11) benutzte Tabelle</translation>
    </message>
    <message>
        <source>velocity v (lines), v aₜ (circles)</source>
        <translation>Geschwindigkeit v (Linien), v aₜ (Kreise)</translation>
    </message>
    <message>
        <source>v̅ / f(F̅)</source>
        <translation>v̅ / f(F̅)</translation>
    </message>
    <message>
        <source>what is left of the plateau at the smallest force, for the largest H over that for the smallest</source>
        <translation>was bei der kleinsten Kraft vom Plateau bleibt: für das größte H durch den Wert für das kleinste</translation>
    </message>
    <message>
        <source>within 0.02 of 1, at velocities below a tenth of region I's end</source>
        <translation>höchstens 0,02 von 1 entfernt, bei Geschwindigkeiten unter einem Zehntel des Endes von Bereich I</translation>
    </message>
    <message>
        <source>within 0.03 of the expected</source>
        <translation>höchstens 0,03 vom Erwarteten entfernt</translation>
    </message>
    <message>
        <source>within 10 % of √2</source>
        <translation>höchstens 10 % von √2 entfernt</translation>
    </message>
    <message>
        <source>zone 1: partial contact</source>
        <translation>Zone 1: Teilkontakt</translation>
    </message>
    <message>
        <source>zone 2: complete contact</source>
        <translation>Zone 2: Vollkontakt</translation>
    </message>
    <message>
        <source>|n| below 0.1; on a resolved line, too, for a plain yes</source>
        <translation>|n| unter 0,1; für ein klares Ja auch auf einer aufgelösten Linie</translation>
    </message>
    <message>
        <source>α = H/(1 + H), Eq. (7)</source>
        <translation>α = H/(1 + H), Gl. (7)</translation>
    </message>
    <message>
        <source>α and β of Eq. (5) over the Hurst exponent</source>
        <translation>α und β aus Gl. (5) über dem Hurst-Exponenten</translation>
    </message>
    <message>
        <source>β = 1, silently in Eq. (12)</source>
        <translation>β = 1, stillschweigend in Gl. (12)</translation>
    </message>
    <message>
        <source>μ/∇z in contact</source>
        <translation>μ/∇z im Kontakt</translation>
    </message>
    <message>
        <source>√2, Eq. (9)</source>
        <translation>√2, Gl. (9)</translation>
    </message>
    <message>
        <source>Friction over velocity</source>
        <translation>Reibung über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>What accuracy costs in time</source>
        <translation>Was Genauigkeit an Zeit kostet</translation>
    </message>
    <message>
        <source>What realizations cost in time</source>
        <translation>Was Realisierungen an Zeit kosten</translation>
    </message>
    <message>
        <source>against realizations</source>
        <translation>über den Realisierungen</translation>
    </message>
    <message>
        <source>against time</source>
        <translation>über der Zeit</translation>
    </message>
    <message>
        <source>best for the time</source>
        <translation>das Beste für die Zeit</translation>
    </message>
    <message>
        <source>coefficient of friction μ</source>
        <translation>Reibungszahl μ</translation>
    </message>
    <message>
        <source>coefficient of friction μ with local friction</source>
        <translation>Reibungszahl μ mit lokaler Reibung</translation>
    </message>
    <message>
        <source>cubic ×1 to ×16</source>
        <translation>kubisch ×1 bis ×16</translation>
    </message>
    <message>
        <source>indentation d</source>
        <translation>Eindringung d</translation>
    </message>
    <message>
        <source>linear ×1 to ×16</source>
        <translation>linear ×1 bis ×16</translation>
    </message>
    <message>
        <source>literal march (difference)</source>
        <translation>wörtliche Schritte (Unterschied)</translation>
    </message>
    <message>
        <source>literal march</source>
        <translation>wörtliche Schritte</translation>
    </message>
    <message>
        <source>nodal (difference)</source>
        <translation>nodal (Unterschied)</translation>
    </message>
    <message>
        <source>mean of %1 lines ± standard error</source>
        <translation>Mittel über %1 Linien ± Standardfehler</translation>
    </message>
    <message>
        <source>deformation alone, mean of %1 lines ± standard error</source>
        <translation>nur Verformung, Mittel über %1 Linien ± Standardfehler</translation>
    </message>
    <message>
        <source>deformation alone, this line</source>
        <translation>nur Verformung, diese Linie</translation>
    </message>
    <message>
        <source>region I</source>
        <translation>Bereich I</translation>
    </message>
    <message>
        <source>relative error of μ</source>
        <translation>relativer Fehler von μ</translation>
    </message>
    <message>
        <source>relative standard error of μ</source>
        <translation>relativer Standardfehler von μ</translation>
    </message>
    <message>
        <source>target %1</source>
        <translation>Ziel %1</translation>
    </message>
    <message>
        <source>this line</source>
        <translation>diese Linie</translation>
    </message>
    <message>
        <source>time of one velocity</source>
        <translation>Zeit einer Geschwindigkeit</translation>
    </message>
    <message>
        <source>time t</source>
        <translation>Zeit t</translation>
    </message>
    <message>
        <source>velocity v</source>
        <translation>Geschwindigkeit v</translation>
    </message>
    <message>
        <source>the force balance is not met</source>
        <translation>das Kräftegleichgewicht ist nicht erfüllt</translation>
    </message>
    <message>
        <source>cannot be combined with interface.friction_coefficient; only one of them may be above 0</source>
        <translation>lässt sich nicht mit interface.friction_coefficient verbinden; nur eines von beiden darf über 0 liegen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>cubic x%1</source>
        <translation>kubisch ×%1</translation>
    </message>
    <message>
        <source>cubic ×%1</source>
        <translation>kubisch ×%1</translation>
    </message>
    <message>
        <source>linear ×%1</source>
        <translation>linear ×%1</translation>
    </message>
    <message>
        <source>linear x%1</source>
        <translation>linear ×%1</translation>
    </message>
    <message>
        <source>dimensionless velocity v̄ = τ v ∇z / (√2 h)</source>
        <translation>dimensionslose Geschwindigkeit v̄ = τ v ∇z / (√2 h)</translation>
    </message>
    <message>
        <source>normalized friction μ / ∇z</source>
        <translation>normierte Reibungszahl μ / ∇z</translation>
    </message>
    <message>
        <source>difference Δ</source>
        <translation>Unterschied Δ</translation>
    </message>
    <message>
        <source>Borders are read from this curve, not from theory.</source>
        <translation>Die Grenzen sind aus dieser Kurve abgelesen, nicht aus der Theorie.</translation>
    </message>
    <message>
        <source>no friction: nothing positive to show on a logarithmic axis</source>
        <translation>keine Reibung: nichts Positives für eine logarithmische Achse</translation>
    </message>
    <message>
        <source>no positive coefficient of friction to show on a logarithmic axis</source>
        <translation>keine positive Reibungszahl für eine logarithmische Achse</translation>
    </message>
    <message>
        <source>no dimensionless axes: they need a line with roughness and one relaxation time</source>
        <translation>keine dimensionslosen Achsen: Sie brauchen eine raue Linie und eine einzige Relaxationszeit</translation>
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
        <source>the lesson hides the curve</source>
        <translation>die Lektion verbirgt die Kurve</translation>
    </message>
    <message>
        <source>%1 of %2 lines</source>
        <translation>%1 von %2 Linien</translation>
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
        <source>this line, settled</source>
        <translation>diese Linie, stationär</translation>
    </message>
    <message>
        <source>this motion, now</source>
        <translation>diese Bewegung, jetzt</translation>
    </message>
    <message>
        <source>before the change</source>
        <translation>vor der Änderung</translation>
    </message>
    <message>
        <source>same parameters</source>
        <translation>gleiche Parameter</translation>
    </message>
    <message>
        <source>length per contact ℓ</source>
        <translation>Länge je Kontakt ℓ</translation>
    </message>
    <message>
        <source>a dashed line will show relaxation at the predicted rate 1/τ + v/ℓ</source>
        <translation>gestrichelt folgt die Relaxation mit der vorhergesagten Rate 1/τ + v/ℓ</translation>
    </message>
    <message>
        <source>rigid body</source>
        <translation>starrer Körper</translation>
    </message>
    <message>
        <source>position</source>
        <translation>Ort</translation>
    </message>
    <message>
        <source>height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Rigid line</source>
        <translation>Starre Linie</translation>
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
        <source>dashed: relaxation at the predicted rate 1/τ + v/ℓ = %1 s⁻¹</source>
        <translation>gestrichelt: Relaxation mit der vorhergesagten Rate 1/τ + v/ℓ = %1 s⁻¹</translation>
    </message>
    <message>
        <source>Dashed: relaxation at the predicted rate 1/τ + v/ℓ, exact for one contact and a small change of velocity, a guide otherwise.</source>
        <translation>Gestrichelt: Relaxation mit der vorhergesagten Rate 1/τ + v/ℓ, exakt für einen Kontakt und eine kleine Änderung der Geschwindigkeit, sonst ein Anhalt.</translation>
    </message>
    <message>
        <source>%1 lines</source>
        <translation>%1 Linien</translation>
    </message>
    <message>
        <source>Regions as read from the curve: I ends 20 % below its line, III lies above 95 % of the maximum.</source>
        <translation>Bereiche aus der Kurve abgelesen: I endet 20 % unter seiner Geraden, III liegt über 95 % des Maximums.</translation>
    </message>
    <message>
        <source>transition</source>
        <translation>Übergang</translation>
    </message>
    <message>
        <source>plateau</source>
        <translation>Plateau</translation>
    </message>
    <message>
        <source>decrease</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>Friction grows in proportion to velocity, Eqs. (5) to (8). Ends where the curve is 20 % below that line.</source>
        <translation>Die Reibung wächst proportional zur Geschwindigkeit, Gl. (5) bis (8). Endet, wo die Kurve 20 % unter dieser Geraden liegt.</translation>
    </message>
    <message>
        <source>From the line to the plateau. Ends where 95 % of the maximum is reached.</source>
        <translation>Von der Geraden zum Plateau. Endet, wo 95 % des Maximums erreicht sind.</translation>
    </message>
    <message>
        <source>Contacts carry on their leading sides only, Eq. (9). Ends where friction falls below 95 % of the maximum.</source>
        <translation>Kontakte tragen nur an ihren Vorderseiten, Gl. (9). Endet, wo die Reibung unter 95 % des Maximums fällt.</translation>
    </message>
    <message>
        <source>other arms</source>
        <translation>andere Arme</translation>
    </message>
    <message>
        <source>I linear</source>
        <translation>I linear</translation>
    </message>
    <message>
        <source>IV decrease</source>
        <translation>IV Abfall</translation>
    </message>
    <message>
        <source>line load p</source>
        <translation>Linienlast p</translation>
    </message>
    <message>
        <source>share of length</source>
        <translation>Längenanteil</translation>
    </message>
    <message>
        <source>mean, force / length</source>
        <translation>Mittel, Kraft / Länge</translation>
    </message>
    <message>
        <source>slope z′ / rms slope</source>
        <translation>Steigung z′ / RMS-Steigung</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>whole line</source>
        <translation>ganze Linie</translation>
    </message>
    <message>
        <source>in contact</source>
        <translation>in Kontakt</translation>
    </message>
    <message>
        <source>normal distribution</source>
        <translation>Normalverteilung</translation>
    </message>
    <message>
        <source>wave number q</source>
        <translation>Wellenzahl q</translation>
    </message>
    <message>
        <source>spectral density C</source>
        <translation>Spektraldichte C</translation>
    </message>
    <message>
        <source>prescribed, H = %1</source>
        <translation>vorgegeben, H = %1</translation>
    </message>
    <message>
        <source>fitted, H = %1</source>
        <translation>angepasst, H = %1</translation>
    </message>
    <message>
        <source>No element is in contact.</source>
        <translation>Kein Element ist in Kontakt.</translation>
    </message>
    <message>
        <source>contact search</source>
        <translation>Kontaktsuche</translation>
    </message>
    <message>
        <source>whether an element touches is asked at each node</source>
        <translation>ob ein Element Kontakt hat, wird an jedem Knoten geprüft</translation>
    </message>
    <message>
        <source>edges of contact are found inside the segments wherever contact is not complete</source>
        <translation>Kontaktränder werden innerhalb der Segmente gefunden, wo der Kontakt nicht vollständig ist</translation>
    </message>
    <message>
        <source>at %1 of %2 velocities; at the other contact is complete, and depth and friction are known</source>
        <translation>bei %1 von %2 Geschwindigkeiten; bei der anderen ist der Kontakt vollständig, Tiefe und Reibung sind bekannt</translation>
    </message>
    <message>
        <source>at %1 of %2 velocities; at the others contact is complete, and depth and friction are known</source>
        <translation>bei %1 von %2 Geschwindigkeiten; bei den anderen ist der Kontakt vollständig, Tiefe und Reibung sind bekannt</translation>
    </message>
    <message>
        <source>the friction curve is of steady sliding</source>
        <translation>die Reibungskurve gilt für stationäres Gleiten</translation>
    </message>
    <message>
        <source>nothing slides steadily</source>
        <translation>nichts gleitet stationär</translation>
    </message>
    <message>
        <source>nodal is the paper's rule for Kelvin elements: where its force jumps arms cannot close over a period; they need linear or cubic</source>
        <translation>nodal ist die Regel der Arbeit für Kelvin-Elemente: Wo ihre Kraft springt, können sich Arme nicht über eine Periode schließen; sie brauchen linear oder kubisch</translation>
    </message>
    <message>
        <source>is 0: without an equilibrium modulus an elastomer cannot carry a constant load; it must be above 0</source>
        <translation>ist 0: Ohne Gleichgewichtsmodul kann ein Elastomer keine konstante Last tragen; nötig ist mehr als 0</translation>
    </message>
    <message>
        <source>a standard solid has one arm, not %1</source>
        <translation>ein Standardkörper hat einen Arm, nicht %1</translation>
    </message>
    <message>
        <source>a comparison needs the same resolution at every velocity</source>
        <translation>ein Vergleich braucht dieselbe Auflösung bei jeder Geschwindigkeit</translation>
    </message>
    <message>
        <source>%1 times oversampling %2 is more than %3 points; allowed are up to %4 elements, or with accuracy.oversampling %5 up to %6</source>
        <translation>%1 mal Überabtastung %2 sind mehr als %3 Punkte; erlaubt sind bis zu %4 Elemente oder mit accuracy.oversampling %5 bis zu %6</translation>
    </message>
    <message>
        <source>is missing; the profile has heights without positions</source>
        <translation>fehlt; das Profil hat Höhen ohne Orte</translation>
    </message>
    <message>
        <source>is missing; a profile needs a file</source>
        <translation>fehlt; ein Profil braucht eine Datei</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>fehlt</translation>
    </message>
    <message>
        <source>chooses scheme and oversampling itself; give it or them</source>
        <translation>wählt Verfahren und Überabtastung selbst; anzugeben ist entweder das eine oder das andere</translation>
    </message>
    <message>
        <source>a scene is one JSON object</source>
        <translation>eine Szene ist ein JSON-Objekt</translation>
    </message>
    <message>
        <source>needs an object of keys</source>
        <translation>braucht ein Objekt mit Schlüsseln</translation>
    </message>
    <message>
        <source>needs an object of modulus and relaxation_time</source>
        <translation>braucht ein Objekt aus modulus und relaxation_time</translation>
    </message>
    <message>
        <source>a key of a section stands inside its section's object</source>
        <translation>ein Schlüssel eines Abschnitts steht im Objekt seines Abschnitts</translation>
    </message>
    <message>
        <source>occurs twice in the same object</source>
        <translation>steht zweimal in demselben Objekt</translation>
    </message>
    <message>
        <source>an object has more than %1 keys</source>
        <translation>ein Objekt hat mehr als %1 Schlüssel</translation>
    </message>
    <message>
        <source>%1 is too close to 0 for a number</source>
        <translation>%1 liegt für eine Zahl zu nahe bei 0</translation>
    </message>
    <message>
        <source>is nested too deeply</source>
        <translation>ist zu tief verschachtelt</translation>
    </message>
    <message>
        <source>is not valid JSON</source>
        <translation>ist kein gültiges JSON</translation>
    </message>
    <message>
        <source>unknown key; the nearest known one is %1</source>
        <translation>unbekannter Schlüssel; der nächste bekannte ist %1</translation>
    </message>
    <message>
        <source>unknown key; an arm has modulus and relaxation_time</source>
        <translation>unbekannter Schlüssel; ein Arm hat modulus und relaxation_time</translation>
    </message>
    <message>
        <source>has no meaning for %1 %2; it belongs to %3</source>
        <translation>hat keine Bedeutung für %1 %2; gehört zu %3</translation>
    </message>
    <message>
        <source>has more than %1 rows</source>
        <translation>hat mehr als %1 Zeilen</translation>
    </message>
    <message>
        <source>JSON in UTF-8 is needed</source>
        <translation>nötig ist JSON in UTF-8</translation>
    </message>
    <message>
        <source>a measured surface is a file that a scene names as surface.file, with surface.kind measured</source>
        <translation>eine gemessene Oberfläche ist eine Datei, die eine Szene als surface.file nennt, mit surface.kind measured</translation>
    </message>
    <message>
        <source>row %1: the comma may divide columns, thousands or decimals; numbers are written with a point and without thousands separators</source>
        <translation>Zeile %1: das Komma kann Spalten, Tausender oder Dezimalen trennen; Zahlen stehen mit Punkt und ohne Tausendertrennung</translation>
    </message>
    <message>
        <source>row %1: column %2 is not a number</source>
        <translation>Zeile %1: in Spalte %2 steht keine Zahl</translation>
    </message>
    <message>
        <source>row %1: column %2 is not a finite number</source>
        <translation>Zeile %1: in Spalte %2 steht keine endliche Zahl</translation>
    </message>
    <message>
        <source>row %1: has %2 columns; position and height, or height alone, are needed</source>
        <translation>Zeile %1: hat %2 Spalten; nötig sind Ort und Höhe oder nur die Höhe</translation>
    </message>
    <message>
        <source>row %1: has %2 columns or more; position and height, or height alone, are needed</source>
        <translation>Zeile %1: hat %2 Spalten oder mehr; nötig sind Ort und Höhe oder nur die Höhe</translation>
    </message>
    <message>
        <source>positions must increase</source>
        <translation>die Orte müssen zunehmen</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>lässt sich nicht öffnen</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>lässt sich nicht lesen</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>ist ein Ordner, keine Datei</translation>
    </message>
    <message>
        <source>is a pipe or a device; only regular files are read here</source>
        <translation>ist eine Pipe oder ein Gerät; hier werden nur gewöhnliche Dateien gelesen</translation>
    </message>
    <message>
        <source>is larger than a scene may be</source>
        <translation>ist größer, als eine Szene sein darf</translation>
    </message>
    <message>
        <source>is a folder; a file name is needed</source>
        <translation>ist ein Ordner; nötig ist ein Dateiname</translation>
    </message>
    <message>
        <source>is not a folder and cannot be created</source>
        <translation>ist kein Ordner und lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>is also an input file and would be replaced</source>
        <translation>ist auch eine Eingabedatei und würde ersetzt</translation>
    </message>
    <message>
        <source>is not a plain file and would be replaced</source>
        <translation>ist keine gewöhnliche Datei und würde ersetzt</translation>
    </message>
    <message>
        <source>is larger than the %1 bytes allowed</source>
        <translation>ist größer als die erlaubten %1 Bytes</translation>
    </message>
    <message>
        <source>holds no scene: Asperity did not write this file, or the scene in it was removed</source>
        <translation>enthält keine Szene: Asperity hat diese Datei nicht geschrieben, oder die Szene darin wurde entfernt</translation>
    </message>
    <message>
        <source>holds no scene: it was made from a table of moduli</source>
        <translation>enthält keine Szene: Die Datei entstand aus einer Tabelle von Moduln</translation>
    </message>
    <message>
        <source>shows many scenes; open the picture or the table of one of them</source>
        <translation>zeigt viele Szenen; zu öffnen ist das Bild oder die Tabelle einer davon</translation>
    </message>
    <message>
        <source>row %1 of %2</source>
        <translation>Zeile %1 von %2</translation>
    </message>
    <message>
        <source>%1 = %2 raw, %3 used</source>
        <translation>%1 = %2 roh, %3 verwendet</translation>
    </message>
    <message>
        <source>rms slope of the equivalent line %1</source>
        <translation>RMS-Steigung der gleichwertigen Linie %1</translation>
    </message>
    <message>
        <source>noise</source>
        <translation>Rauschen</translation>
    </message>
    <message>
        <source>too short</source>
        <translation>zu kurz</translation>
    </message>
    <message>
        <source>too long</source>
        <translation>zu lang</translation>
    </message>
    <message>
        <source>Measured surface</source>
        <translation>Gemessene Oberfläche</translation>
    </message>
    <message>
        <source>raw, about its mean</source>
        <translation>roh, um den Mittelwert</translation>
    </message>
    <message>
        <source>used</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>raw</source>
        <translation>roh</translation>
    </message>
    <message>
        <source>all heights are equal</source>
        <translation>alle Höhen sind gleich</translation>
    </message>
    <message>
        <source>height z / Rq</source>
        <translation>Höhe z / Rq</translation>
    </message>
    <message>
        <source>height z / Pq</source>
        <translation>Höhe z / Pq</translation>
    </message>
    <message>
        <source>Summits are up, as in the file. C(q) is two-sided, h² = 2 ∫ C dq, under a Hann window; tinted: not roughness but the length of the profile, noise or too few points to a wave.</source>
        <translation>Gipfel sind oben wie in der Datei. C(q) ist zweiseitig, h² = 2 ∫ C dq, mit Hann-Fenster; getönt: nicht Rauheit, sondern die Länge des Profils, Rauschen oder zu wenige Punkte je Welle.</translation>
    </message>
    <message>
        <source>the rms slope of the line is above 0.3: the model assumes small slopes, so its friction is only an estimate</source>
        <translation>die RMS-Steigung der Linie liegt über 0,3: Das Modell setzt kleine Steigungen voraus, daher ist seine Reibung nur eine Schätzung</translation>
    </message>
    <message>
        <source>few contacts carry the load: results depend on the single summits of this line and on its period</source>
        <translation>wenige Kontakte tragen die Last: Ergebnisse hängen von den einzelnen Gipfeln dieser Linie und von ihrer Periode ab</translation>
    </message>
    <message>
        <source>sliding excites frequencies outside of those that the elastomer was measured at</source>
        <translation>das Gleiten regt Frequenzen außerhalb derer an, bei denen das Elastomer gemessen wurde</translation>
    </message>
    <message>
        <source>the temperature lies outside of those that the elastomer was measured at</source>
        <translation>die Temperatur liegt außerhalb derer, bei denen das Elastomer gemessen wurde</translation>
    </message>
    <message>
        <source>strains are larger than those that the elastomer was measured at</source>
        <translation>die Dehnungen sind größer als die, bei denen das Elastomer gemessen wurde</translation>
    </message>
    <message>
        <source>the end of the profile does not meet its beginning: the period repeats with a step, which carries load like a sharp edge; surface.seam mirror or blend avoids it</source>
        <translation>das Ende des Profils trifft seinen Anfang nicht: Die Periode wiederholt sich mit einer Stufe, die wie eine scharfe Kante Last trägt; surface.seam mirror oder blend machen keine</translation>
    </message>
    <message>
        <source>single points of the measured surface stand far out of their neighbours, like spikes, and carry load: where they are errors of the measurement, surface.outliers=6 replaces them</source>
        <translation>einzelne Punkte der gemessenen Oberfläche ragen wie Nadeln weit aus ihren Nachbarn heraus und tragen Last: Wo sie Messfehler sind, ersetzt surface.outliers=6 sie</translation>
    </message>
    <message>
        <source>the heights of rows have steps about as large as neighbours differ, and the lines are too steep by these steps: measure in finer steps, or remove short waves by surface.short_wave_cut</source>
        <translation>die Höhen von Zeilen haben Stufen, die etwa so groß sind wie der Unterschied von Nachbarn, und die Linien sind um diese Stufen zu steil: in feineren Stufen messen, oder kurze Wellen mit surface.short_wave_cut entfernen</translation>
    </message>
    <message>
        <source>the profile is part of a circle, as of a tyre or a roller, which a parabola does not follow, and this form carries load: measure a shorter piece, or remove it by surface.long_wave_cut</source>
        <translation>das Profil ist Teil eines Kreises, wie bei einem Reifen oder einer Walze, dem eine Parabel nicht folgt, und diese Form trägt Last: ein kürzeres Stück messen, oder sie mit surface.long_wave_cut entfernen</translation>
    </message>
    <message>
        <source>the rows of the surface are so few, or so much alike, that they count as fewer than about ten independent lines: the standard error of the mean is only roughly known</source>
        <translation>die Zeilen der Oberfläche sind so wenige oder einander so ähnlich, dass sie als weniger als etwa zehn unabhängige Linien zählen: Der Standardfehler des Mittels ist nur grob bekannt</translation>
    </message>
    <message>
        <source>so much power is dissipated that the elastomer would become warmer, which is not computed</source>
        <translation>es wird so viel Leistung dissipiert, dass das Elastomer wärmer würde, was nicht berechnet wird</translation>
    </message>
    <message>
        <source>too few elements are in contact for the tangential force, which is the error of their sum</source>
        <translation>für die Tangentialkraft sind zu wenige Elemente im Kontakt; sie ist der Fehler ihrer Summe</translation>
    </message>
    <message>
        <source>the velocity is above 1000 m/s: real elastomers are not slid so fast, and the model leaves out the inertia that would then count</source>
        <translation>die Geschwindigkeit liegt über 1000 m/s: so schnell gleitet kein wirkliches Elastomer, und dem Modell fehlt die Trägheit, die dann zählte</translation>
    </message>
    <message>
        <source>The length after which the line repeats; where the line has a file it may be left out and is as long as the file says.</source>
        <translation>Länge, nach der sich die Linie wiederholt; hat die Linie eine Datei, kann sie fehlen und ist so lang, wie die Datei sagt.</translation>
    </message>
    <message>
        <source>Elements per period: the shortest wave of a random line is two of them long; where the line has a file they may be left out and are as many as the file has.</source>
        <translation>Elemente je Periode: Die kürzeste Welle einer Zufallslinie ist zwei davon lang; hat die Linie eine Datei, können sie fehlen und sind so viele, wie die Datei hat.</translation>
    </message>
    <message>
        <source>file</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>File of the line, relative to the scene: a CSV profile of position and height in metres, a measured surface of any kind, or a table of a spectrum.</source>
        <translation>Datei der Linie, relativ zur Szene: ein CSV-Profil aus Ort und Höhe in Metern, eine gemessene Oberfläche beliebiger Art oder die Tabelle eines Spektrums.</translation>
    </message>
    <message>
        <source>What the file is taken for; auto: the program finds out and says what it found.</source>
        <translation>Wofür die Datei genommen wird; auto: Das Programm findet es heraus und sagt, was es fand.</translation>
    </message>
    <message>
        <source>position unit</source>
        <translation>Einheit des Ortes</translation>
    </message>
    <message>
        <source>Unit of positions along the surface; auto: as the file states.</source>
        <translation>Einheit der Orte entlang der Oberfläche; auto: wie die Datei angibt.</translation>
    </message>
    <message>
        <source>height unit</source>
        <translation>Einheit der Höhe</translation>
    </message>
    <message>
        <source>Unit of heights; auto: as the file states.</source>
        <translation>Einheit der Höhen; auto: wie die Datei angibt.</translation>
    </message>
    <message>
        <source>position column</source>
        <translation>Spalte des Ortes</translation>
    </message>
    <message>
        <source>Column of positions, counted from 1; 0: the program finds it.</source>
        <translation>Spalte der Orte, ab 1 gezählt; 0: Das Programm findet sie.</translation>
    </message>
    <message>
        <source>height column</source>
        <translation>Spalte der Höhe</translation>
    </message>
    <message>
        <source>Column or channel of heights, counted from 1; 0: the program finds it.</source>
        <translation>Spalte oder Kanal der Höhen, ab 1 gezählt; 0: Das Programm findet sie.</translation>
    </message>
    <message>
        <source>Row of a topography that is the line, counted from 1; 0: all rows, each a realization.</source>
        <translation>Zeile einer Topographie, die die Linie ist, ab 1 gezählt; 0: alle Zeilen, jede eine Realisierung.</translation>
    </message>
    <message>
        <source>Direction of sliding on a topography: along its rows (x) or across them (y).</source>
        <translation>Gleitrichtung auf einer Topographie: entlang ihrer Zeilen (x) oder quer dazu (y).</translation>
    </message>
    <message>
        <source>gaps</source>
        <translation>Lücken</translation>
    </message>
    <message>
        <source>Points that were not measured: refused, or interpolated along the row.</source>
        <translation>Nicht gemessene Punkte: abgelehnt oder entlang der Zeile interpoliert.</translation>
    </message>
    <message>
        <source>Heights farther from the form than so many median deviations are replaced by interpolation; 0: all are kept.</source>
        <translation>Höhen, die weiter als so viele mediane Abweichungen von der Form liegen, werden durch Interpolation ersetzt; 0: alle bleiben.</translation>
    </message>
    <message>
        <source>How the ends of the profile meet where its period repeats: mirrored (the period is twice the profile), blended, with random phases, or as they are, which may be a step.</source>
        <translation>Wie die Enden des Profils sich treffen, wo die Periode sich wiederholt: gespiegelt (die Periode ist zweimal das Profil), überblendet, mit Zufallsphasen oder wie sie sind, was eine Stufe sein kann.</translation>
    </message>
    <message>
        <source>blend length</source>
        <translation>Überblendung</translation>
    </message>
    <message>
        <source>Stretch over which the end of the profile is blended into its beginning, and by which the period is shorter; 0: a tenth of the profile.</source>
        <translation>Strecke, auf der das Ende des Profils in seinen Anfang überblendet wird und um die die Periode kürzer ist; 0: ein Zehntel des Profils.</translation>
    </message>
    <message>
        <source>The line that slides: as measured, right for grooves across the sliding; or the isotropic equivalent, C_line = pi q C2, which an isotropic surface needs and which is steeper by about sqrt 2.</source>
        <translation>Die Linie, die gleitet: wie gemessen, richtig für Rillen quer zum Gleiten; oder die isotrop gleichwertige, C_line = pi q C2, die eine isotrope Oberfläche braucht und die etwa um Wurzel 2 steiler ist.</translation>
    </message>
    <message>
        <source>contact side</source>
        <translation>Kontaktseite</translation>
    </message>
    <message>
        <source>Which side of the measured surface touches the rubber: its summits (the line is the heights turned over, because the lowest points of a line touch first) or its valleys (the heights as they stand).</source>
        <translation>Welche Seite der gemessenen Oberfläche das Gummi berührt: ihre Gipfel (die Linie sind die umgedrehten Höhen, weil die tiefsten Punkte einer Linie zuerst Kontakt haben) oder ihre Täler (die Höhen, wie sie sind).</translation>
    </message>
    <message>
        <source>kind of spectrum</source>
        <translation>Art des Spektrums</translation>
    </message>
    <message>
        <source>What the spectrum's numbers are: c1_two_sided (&lt;h^2&gt; = 2 integral C1 dq), c1_one_sided (&lt;h^2&gt; = integral C1 dq) or c2 of an isotropic surface (&lt;h^2&gt; = 2 pi integral C2 q dq); per wave number where the table has that column, else per spatial frequency. It must be stated.</source>
        <translation>Was die Zahlen des Spektrums sind: c1_two_sided (&lt;h^2&gt; = 2 Integral C1 dq), c1_one_sided (&lt;h^2&gt; = Integral C1 dq) oder c2 einer isotropen Oberfläche (&lt;h^2&gt; = 2 pi Integral C2 q dq); je Wellenzahl, wo die Tabelle diese Spalte hat, sonst je Ortsfrequenz. Sie muss angegeben werden.</translation>
    </message>
    <message>
        <source>What is held constant: the normal force, the indentation or the nominal pressure.</source>
        <translation>Was konstant gehalten wird: die Normalkraft, die Eindringung oder der nominelle Druck.</translation>
    </message>
    <message>
        <source>nominal pressure</source>
        <translation>nomineller Druck</translation>
    </message>
    <message>
        <source>Normal force over the area of one period and the width: F_N = p_0 L width.</source>
        <translation>Normalkraft durch die Fläche aus einer Periode und der Breite: F_N = p_0 L Breite.</translation>
    </message>
    <message>
        <source>width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>Width that turns the nominal pressure into the force on the line; results depend on it; 0: the period, the square of the reduction method.</source>
        <translation>Breite, die aus dem nominellen Druck die Kraft auf die Linie macht; Ergebnisse hängen von ihr ab; 0: die Periode, das Quadrat der Reduktionsmethode.</translation>
    </message>
    <message>
        <source>Lines that the friction curve is averaged over: random ones, or rows of a measured surface; 0, of rows alone: every row.</source>
        <translation>Linien, über die die Reibungskurve gemittelt wird: Zufallslinien oder Zeilen einer gemessenen Oberfläche; 0, nur bei Zeilen: jede Zeile.</translation>
    </message>
    <message>
        <source>%1; %2; mirrored, so that the period is twice the file's</source>
        <translation>%1; %2; gespiegelt, so dass die Periode zweimal die der Datei ist</translation>
    </message>
    <message>
        <source>%1; %2; its end is blended into its beginning</source>
        <translation>%1; %2; ihr Ende ist in ihren Anfang überblendet</translation>
    </message>
    <message>
        <source>%1; its spectrum with random phases</source>
        <translation>%1; ihr Spektrum mit Zufallsphasen</translation>
    </message>
    <message>
        <source>%1; %2; repeated as it is</source>
        <translation>%1; %2; wiederholt, wie sie ist</translation>
    </message>
    <message>
        <source>the indentation that carries %1 on a width of %2 is sought; results depend on the width</source>
        <translation>gesucht wird die Eindringung, die %1 auf einer Breite von %2 trägt; Ergebnisse hängen von der Breite ab</translation>
    </message>
    <message>
        <source>the indentation that carries %1 on the square of the period is sought; results depend on the width</source>
        <translation>gesucht wird die Eindringung, die %1 auf dem Quadrat der Periode trägt; Ergebnisse hängen von der Breite ab</translation>
    </message>
    <message>
        <source>%1 rows of the measured surface</source>
        <translation>%1 Zeilen der gemessenen Oberfläche</translation>
    </message>
    <message>
        <source>the measured surface as it is along the sliding</source>
        <translation>die gemessene Oberfläche, wie sie entlang des Gleitens ist</translation>
    </message>
    <message>
        <source>its summits touch</source>
        <translation>ihre Gipfel haben Kontakt</translation>
    </message>
    <message>
        <source>its valleys touch</source>
        <translation>ihre Täler haben Kontakt</translation>
    </message>
    <message>
        <source>waves of the file's spectrum with random phases are summed</source>
        <translation>Wellen des Spektrums der Datei werden mit Zufallsphasen summiert</translation>
    </message>
    <message>
        <source>every row of the measured surface</source>
        <translation>jede Zeile der gemessenen Oberfläche</translation>
    </message>
    <message>
        <source>%1 is not above surface.short_wave_cut, %2</source>
        <translation>%1 ist nicht größer als surface.short_wave_cut, %2</translation>
    </message>
    <message>
        <source>%1 m, the longest wave of the spectrum, is outside %2</source>
        <translation>%1 m, die längste Welle des Spektrums, liegt nicht in %2</translation>
    </message>
    <message>
        <source>%1 m with %2 elements carries no wave of the spectrum, whose waves are %3 to %4 m long</source>
        <translation>%1 m mit %2 Elementen trägt keine Welle des Spektrums, dessen Wellen %3 bis %4 m lang sind</translation>
    </message>
    <message>
        <source>leaves no wave of the spectrum</source>
        <translation>lässt keine Welle des Spektrums übrig</translation>
    </message>
    <message>
        <source>%1 m is less than two points of the file, which are %2 m apart</source>
        <translation>%1 m ist weniger als zwei Punkte der Datei, die %2 m Abstand haben</translation>
    </message>
    <message>
        <source>%1 is outside 0 to 1; the file has a single profile</source>
        <translation>%1 liegt nicht in 0 bis 1; die Datei hat ein einziges Profil</translation>
    </message>
    <message>
        <source>%1 is outside 0 to %2, the rows of the file</source>
        <translation>%1 liegt nicht in 0 bis %2, den Zeilen der Datei</translation>
    </message>
    <message>
        <source>has no row with %1 measured points or more</source>
        <translation>hat keine Zeile mit %1 oder mehr gemessenen Punkten</translation>
    </message>
    <message>
        <source>%1 is more than the single profile of the file; 0 is every row</source>
        <translation>%1 ist mehr als das einzige Profil der Datei; 0 heißt jede Zeile</translation>
    </message>
    <message>
        <source>%1 is more than the rows of the file with %2 measured points or more, which are %3 of %4; 0 is every one of them</source>
        <translation>%1 ist mehr als die Zeilen der Datei mit %2 oder mehr gemessenen Punkten, das sind %3 von %4; 0 heißt jede von ihnen</translation>
    </message>
    <message>
        <source>%1 is more than %2, the number of rows that the scene uses</source>
        <translation>%1 ist mehr als %2, die Zahl der Zeilen, die die Szene verwendet</translation>
    </message>
    <message>
        <source>%1 is outside 0 to %2, the rows that the scene uses</source>
        <translation>%1 liegt außerhalb von 0 bis %2, den Zeilen, die die Szene verwendet</translation>
    </message>
    <message>
        <source>%1 is more than the %2 rows of the file; 0 is every row</source>
        <translation>%1 ist mehr als die %2 Zeilen der Datei; 0 heißt jede Zeile</translation>
    </message>
    <message>
        <source>%1 is more than the period of %2 that the file gives with this seam</source>
        <translation>%1 ist mehr als die Periode von %2, die die Datei mit dieser Naht ergibt</translation>
    </message>
    <message>
        <source>%1 has less than %2 points of the file</source>
        <translation>%1 hat weniger als %2 Punkte der Datei</translation>
    </message>
    <message>
        <source>%1 is more than half of the profile, which is %2 long</source>
        <translation>%1 ist mehr als die Hälfte des Profils, das %2 lang ist</translation>
    </message>
    <message>
        <source>row %1 has no measured point within %2 m</source>
        <translation>Zeile %1 hat keinen gemessenen Punkt innerhalb von %2 m</translation>
    </message>
    <message>
        <source>one row with fewer than three heights is left out</source>
        <translation>eine Zeile mit weniger als drei Höhen ist ausgelassen</translation>
    </message>
    <message>
        <source>%1 rows with fewer than three heights are left out</source>
        <translation>%1 Zeilen mit weniger als drei Höhen sind ausgelassen</translation>
    </message>
    <message>
        <source>shown is row %1; %2 rows are lines</source>
        <translation>gezeigt ist Zeile %1; %2 Zeilen sind Linien</translation>
    </message>
    <message>
        <source>one point without a height is interpolated</source>
        <translation>ein Punkt ohne Höhe ist interpoliert</translation>
    </message>
    <message>
        <source>%1 points without a height are interpolated</source>
        <translation>%1 Punkte ohne Höhe sind interpoliert</translation>
    </message>
    <message>
        <source>one outlier is interpolated</source>
        <translation>ein Ausreißer ist interpoliert</translation>
    </message>
    <message>
        <source>%1 outliers are interpolated</source>
        <translation>%1 Ausreißer sind interpoliert</translation>
    </message>
    <message>
        <source>%1 points of all rows stand far out of their neighbours, like spikes: where they are errors of the measurement, surface.outliers=%2 replaces them</source>
        <translation>%1 Punkte aller Zeilen ragen wie Nadeln weit aus ihren Nachbarn heraus: Wo sie Messfehler sind, ersetzt surface.outliers=%2 sie</translation>
    </message>
    <message>
        <source>one period of the line is %1 long, twice the profile</source>
        <translation>eine Periode der Linie ist %1 lang, zweimal das Profil</translation>
    </message>
    <message>
        <source>the long-wave cut-off of %1 is longer than the profile of %2: hardly any wave is removed, and the values are no roughness parameters of ISO 21920-2</source>
        <translation>die lange Grenzwellenlänge von %1 ist länger als das Profil von %2: kaum eine Welle wird entfernt, und die Werte sind keine Rauheitskenngrößen nach ISO 21920-2</translation>
    </message>
    <message>
        <source>the spectrum is a power law between each two of its points</source>
        <translation>zwischen je zwei seiner Punkte ist das Spektrum ein Potenzgesetz</translation>
    </message>
    <message>
        <source>the wave numbers are whole multiples of one step, as of a periodogram: each value of the spectrum is its mean over a step</source>
        <translation>die Wellenzahlen sind ganze Vielfache eines Schritts, wie die eines Periodogramms: jeder Wert des Spektrums ist sein Mittel über einen Schritt</translation>
    </message>
    <message>
        <source>one period of the line is %1 long</source>
        <translation>eine Periode der Linie ist %1 lang</translation>
    </message>
    <message>
        <source>the spectrum is reliable for wavelengths of %1 to %2; shorter ones are noise</source>
        <translation>das Spektrum ist für Wellenlängen von %1 bis %2 verlässlich; kürzere sind Rauschen</translation>
    </message>
    <message>
        <source>the spectrum is reliable for wavelengths of %1 to %2, as far as the tip was sharper than these</source>
        <translation>das Spektrum ist für Wellenlängen von %1 bis %2 verlässlich, soweit die Spitze schärfer war als diese</translation>
    </message>
    <message>
        <source>the line is the surface as measured</source>
        <translation>die Linie ist die Oberfläche wie gemessen</translation>
    </message>
    <message>
        <source>the line is turned over, because the summits touch</source>
        <translation>die Linie ist umgedreht, weil die Gipfel Kontakt haben</translation>
    </message>
    <message>
        <source>the line is not turned over: the valleys touch</source>
        <translation>die Linie ist nicht umgedreht: Die Täler haben Kontakt</translation>
    </message>
    <message>
        <source>%1 is not a unit of %2; allowed is %3, with mm, µm or nm as well</source>
        <translation>%1 ist keine Einheit von %2; erlaubt ist %3, auch mit mm, µm oder nm</translation>
    </message>
    <message>
        <source>the loads of the points add up to %1 % of the normal force, because contacts are hardly longer than the distance between points; a larger accuracy.oversampling has more points</source>
        <translation>die Lasten der Punkte ergeben zusammen %1 % der Normalkraft, weil Kontakte kaum länger sind als der Abstand der Punkte; ein größeres accuracy.oversampling hat mehr Punkte</translation>
    </message>
    <message>
        <source>the powers at the points add up to %1 % of the power of friction, because the points or the segments of the line are coarse; a larger accuracy.oversampling makes both finer</source>
        <translation>die Leistungen an den Punkten ergeben zusammen %1 % der Reibungsleistung, weil die Punkte oder die Segmente der Linie grob sind; ein größeres accuracy.oversampling macht beide feiner</translation>
    </message>
    <message>
        <source>the powers of the elements add up to %1 % of the power of friction: separate elements balance it only where many of them are in each contact</source>
        <translation>die Leistungen der Elemente ergeben zusammen %1 % der Reibungsleistung: Einzelne Elemente gleichen sie nur aus, wo viele von ihnen in jedem Kontakt liegen</translation>
    </message>
    <message>
        <source>the loads of the elements add up to %1 % of the normal force, because one element more or less changes it by so much; more surface.elements change it by less</source>
        <translation>die Lasten der Elemente ergeben zusammen %1 % der Normalkraft, weil ein Element mehr oder weniger sie so stark ändert; mehr surface.elements ändern sie weniger</translation>
    </message>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>Not drawn: %1, which does not apply anywhere on this axis.</source>
        <translation>Nicht gezeichnet: %1. Die Theorie gilt nirgends auf dieser Achse.</translation>
    </message>
    <message>
        <source>Not drawn: %1, which does not predict this quantity in this scene.</source>
        <translation>Nicht gezeichnet: %1. Die Theorie sagt diese Größe in dieser Szene nicht voraus.</translation>
    </message>
    <message>
        <source>%1 tables are more than %2</source>
        <translation>%1 Tabellen sind mehr als %2</translation>
    </message>
    <message>
        <source>%1 is given more than once</source>
        <translation>%1 ist mehr als einmal angegeben</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not KEY or KEY=LOW:HIGH</source>
        <translation>„%1“ ist weder SCHLÜSSEL noch SCHLÜSSEL=VON:BIS</translation>
    </message>
    <message>
        <source>the value of %1 is missing</source>
        <translation>der Wert von %1 fehlt</translation>
    </message>
    <message>
        <source>%1 is not above 0</source>
        <translation>%1 ist nicht größer als 0</translation>
    </message>
    <message>
        <source>the spectrum %1 is below 0</source>
        <translation>das Spektrum %1 ist kleiner als 0</translation>
    </message>
    <message>
        <source>has %1 rows; at least 2 are needed</source>
        <translation>hat %1 Zeilen; mindestens 2 sind nötig</translation>
    </message>
    <message>
        <source>has two rows for the wave number %1 1/m</source>
        <translation>hat zwei Zeilen für die Wellenzahl %1 1/m</translation>
    </message>
    <message>
        <source>has no wave with a strength above 0</source>
        <translation>hat keine Welle mit einer Stärke über 0</translation>
    </message>
    <message>
        <source>is beyond what a number can hold</source>
        <translation>ist mehr, als eine Zahl fassen kann</translation>
    </message>
    <message>
        <source>a spectrum is a table whose header names wave_number, spatial_frequency or wavelength, and the spectrum in another column</source>
        <translation>ein Spektrum ist eine Tabelle, deren Kopf wave_number, spatial_frequency oder wavelength nennt, und das Spektrum in einer anderen Spalte</translation>
    </message>
    <message>
        <source>is missing; a measured surface needs a file</source>
        <translation>fehlt; eine gemessene Oberfläche braucht eine Datei</translation>
    </message>
    <message>
        <source>is missing; a spectrum needs a file</source>
        <translation>fehlt; ein Spektrum braucht eine Datei</translation>
    </message>
    <message>
        <source>is missing; allowed is one of c1_two_sided, c1_one_sided, c2</source>
        <translation>fehlt; erlaubt ist eines von c1_two_sided, c1_one_sided, c2</translation>
    </message>
    <message>
        <source>%1: it is another file now: its SHA-256 is %2, and the result was made from %3</source>
        <translation>%1: ist jetzt eine andere Datei: ihr SHA-256 ist %2, und das Ergebnis kam aus %3</translation>
    </message>
    <message>
        <source>the profile is too short, or too noisy, for a spectrum that can be relied on</source>
        <translation>das Profil ist zu kurz oder zu verrauscht für ein Spektrum, auf das man sich verlassen kann</translation>
    </message>
    <message>
        <source>is %1, not a table of numbers as text</source>
        <translation>ist %1, keine Zahlentabelle als Text</translation>
    </message>
    <message>
        <source>has several tables of friction, at lines %1 and %2; each needs a file of its own, or all one table with a column that tells them apart, such as temperature or label</source>
        <translation>hat mehrere Tabellen der Reibung, in den Zeilen %1 und %2; jede braucht eine eigene Datei, oder alle eine Tabelle mit einer Spalte, die sie unterscheidet, etwa temperature oder label</translation>
    </message>
    <message>
        <source>not used: %1</source>
        <translation>nicht benutzt: %1</translation>
    </message>
    <message>
        <source>the rows from line %1 on have the columns of the table above them</source>
        <translation>die Werte ab Zeile %1 haben die Spalten der Tabelle darüber</translation>
    </message>
    <message>
        <source>tables of numbers that are not used: at line %1</source>
        <translation>Tabellen mit Zahlen, die nicht verwendet werden: in Zeile %1</translation>
    </message>
    <message>
        <source>line %1: '%2' is not a number</source>
        <translation>Zeile %1: „%2“ ist keine Zahl</translation>
    </message>
    <message>
        <source>its column %1 is a spectrum of a line, which surface.spectrum_kind does not say</source>
        <translation>seine Spalte %1 ist das Spektrum einer Linie, was surface.spectrum_kind nicht sagt</translation>
    </message>
    <message>
        <source>its column %1 is a spectrum of an area, which surface.spectrum_kind does not say</source>
        <translation>seine Spalte %1 ist das Spektrum einer Fläche, was surface.spectrum_kind nicht sagt</translation>
    </message>
    <message>
        <source>has no rows of numbers</source>
        <translation>hat keine Zeilen mit Zahlen</translation>
    </message>
    <message>
        <source>has no rows of numbers; line %1: '%2' is not a number</source>
        <translation>hat keine Zeilen mit Zahlen; Zeile %1: „%2“ ist keine Zahl</translation>
    </message>
    <message>
        <source>has more than %1 numbers</source>
        <translation>hat mehr als %1 Zahlen</translation>
    </message>
    <message>
        <source>line %1: has %2 fields where the lines before have %3</source>
        <translation>Zeile %1: hat %2 Felder, die Zeilen davor haben %3</translation>
    </message>
    <message>
        <source>line %1: '%2' in column %3 is not a number</source>
        <translation>Zeile %1: „%2“ in Spalte %3 ist keine Zahl</translation>
    </message>
    <message>
        <source>ends too early: %1 bytes are needed from byte %2 on, and %3 are there</source>
        <translation>endet zu früh: ab Byte %2 werden %1 Bytes gebraucht, und %3 sind da</translation>
    </message>
    <message>
        <source>the header has no %1</source>
        <translation>im Kopf fehlt %1</translation>
    </message>
    <message>
        <source>%1 in the header is not a number above 0</source>
        <translation>%1 im Kopf ist keine Zahl über 0</translation>
    </message>
    <message>
        <source>is not a %1 file</source>
        <translation>ist keine %1-Datei</translation>
    </message>
    <message>
        <source>the header of the %1 file has no end</source>
        <translation>der Kopf der %1-Datei hat kein Ende</translation>
    </message>
    <message>
        <source>byte %1: the text has no end</source>
        <translation>Byte %1: der Text hat kein Ende</translation>
    </message>
    <message>
        <source>%1 %2 is not known</source>
        <translation>%1 %2 ist nicht bekannt</translation>
    </message>
    <message>
        <source>the file has %1 channels</source>
        <translation>die Datei hat %1 Kanäle</translation>
    </message>
    <message>
        <source>has no channel of heights</source>
        <translation>hat keinen Kanal mit Höhen</translation>
    </message>
    <message>
        <source>The channel &apos;%1&apos; is read, the file has %2; surface.height_column chooses another.</source>
        <translation>Gelesen wird der Kanal „%1“, die Datei hat %2; surface.height_column wählt einen anderen.</translation>
    </message>
    <message>
        <source>The channel has a mask, which is not used.</source>
        <translation>Der Kanal hat eine Maske, die nicht benutzt wird.</translation>
    </message>
    <message>
        <source>cannot be converted: there is no temporary folder</source>
        <translation>lässt sich nicht umwandeln: es gibt keinen Ordner für Zwischendateien</translation>
    </message>
    <message>
        <source>is of a kind that only Gwyddion reads, which is not installed; text (profiles, matrices, points) and files of these kinds are read without it: %1</source>
        <translation>ist von einer Art, die nur Gwyddion liest, und das ist nicht installiert; ohne es werden Text (Profile, Matrizen, Punkte) und Dateien dieser Arten gelesen: %1</translation>
    </message>
    <message>
        <source>is %1; without Gwyddion, which is not installed, text (profiles, matrices, points) and files of these kinds are read: %2</source>
        <translation>ist %1; ohne Gwyddion, das nicht installiert ist, werden Text (Profile, Matrizen, Punkte) und Dateien dieser Arten gelesen: %2</translation>
    </message>
    <message>
        <source>cannot be converted: Gwyddion does not start</source>
        <translation>lässt sich nicht umwandeln: Gwyddion startet nicht</translation>
    </message>
    <message>
        <source>cannot be converted: Gwyddion has not ended within %1 s</source>
        <translation>lässt sich nicht umwandeln: Gwyddion war nach %1 s nicht fertig</translation>
    </message>
    <message>
        <source>is of a kind that Gwyddion does not read either</source>
        <translation>ist von einer Art, die auch Gwyddion nicht liest</translation>
    </message>
    <message>
        <source>is needed (%1): the file states no unit of positions, and in metres the line would be %2 m long</source>
        <translation>wird gebraucht (%1): Die Datei nennt keine Einheit der Orte, und in Metern wäre die Linie %2 m lang</translation>
    </message>
    <message>
        <source>is needed (in m): the file does not say how far its points are apart</source>
        <translation>wird gebraucht (in m): die Datei sagt nicht, wie weit ihre Punkte auseinanderliegen</translation>
    </message>
    <message>
        <source>point spacing</source>
        <translation>Punktabstand</translation>
    </message>
    <message>
        <source>Distance between points where the file does not state one, as in a list of heights alone; 0: as the file states.</source>
        <translation>Abstand der Punkte, wenn die Datei keinen angibt, etwa bei einer Liste nur von Höhen; 0: wie in der Datei.</translation>
    </message>
    <message>
        <source>is needed (%1): the file states no unit of heights, and in metres the rms slope would be %2</source>
        <translation>wird gebraucht (%1): die Datei nennt keine Einheit der Höhen, und in Metern wäre die mittlere Steigung %2</translation>
    </message>
    <message>
        <source>is needed (%1): the file states no unit of positions, and in metres the rms slope would be %2</source>
        <translation>wird gebraucht (%1): die Datei nennt keine Einheit der Orte, und in Metern wäre die mittlere Steigung %2</translation>
    </message>
    <message>
        <source>has %1 points along x; at least %2 are needed</source>
        <translation>hat %1 Punkte in x-Richtung; mindestens %2 werden gebraucht</translation>
    </message>
    <message>
        <source>its points are no length above 0 apart</source>
        <translation>der Abstand ihrer Punkte ist keine Länge über 0</translation>
    </message>
    <message>
        <source>has no heights, only gaps</source>
        <translation>hat keine Höhen, nur Lücken</translation>
    </message>
    <message>
        <source>has lengths or heights beyond %1 m</source>
        <translation>hat Längen oder Höhen über %1 m</translation>
    </message>
    <message>
        <source>a profile as text</source>
        <translation>Profil in Textform</translation>
    </message>
    <message>
        <source>a matrix of heights as text</source>
        <translation>Matrix von Höhen in Textform</translation>
    </message>
    <message>
        <source>points x, y, z as text</source>
        <translation>Punkte x, y, z in Textform</translation>
    </message>
    <message>
        <source>a file that Gwyddion has converted</source>
        <translation>von Gwyddion umgewandelte Datei</translation>
    </message>
    <message>
        <source>Read as %1: %2 points, %3 apart.</source>
        <translation>Gelesen als %1: %2 Punkte im Abstand von %3.</translation>
    </message>
    <message>
        <source>Read as %1: %2 x %3 points, %4 and %5 apart.</source>
        <translation>Gelesen als %1: %2 × %3 Punkte im Abstand von %4 und %5.</translation>
    </message>
    <message>
        <source>Read as %1: %2 x %3 points. Points are %4 apart; how far the rows are apart is not known.</source>
        <translation>Gelesen als %1: %2 × %3 Punkte. Die Punkte haben einen Abstand von %4; der Abstand der Zeilen ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Positions are %1, heights %2.</source>
        <translation>Orte sind %1, Höhen %2.</translation>
    </message>
    <message>
        <source>Positions are %1 and %2, heights %3.</source>
        <translation>Orte sind %1 und %2, Höhen %3.</translation>
    </message>
    <message>
        <source>Columns of the grid are numbered by %1, rows by %2; heights are %3.</source>
        <translation>Die Spalten des Gitters nummeriert %1, die Zeilen %2; Höhen sind %3.</translation>
    </message>
    <message>
        <source>Positions are in %1, as the file states.</source>
        <translation>Die Orte sind in %1, wie die Datei sagt.</translation>
    </message>
    <message>
        <source>Positions are in %1, as surface.position_unit says.</source>
        <translation>Die Orte sind in %1, wie surface.position_unit sagt.</translation>
    </message>
    <message>
        <source>The points are %1 apart, as surface.point_spacing says.</source>
        <translation>Der Punktabstand ist %1, wie surface.point_spacing sagt.</translation>
    </message>
    <message>
        <source>The file states no unit of positions: they are taken as metres.</source>
        <translation>Die Datei nennt keine Einheit der Orte: sie gelten als Meter.</translation>
    </message>
    <message>
        <source>Heights are in %1, as the file states.</source>
        <translation>Die Höhen sind in %1, wie die Datei sagt.</translation>
    </message>
    <message>
        <source>Heights are in %1, as surface.height_unit says.</source>
        <translation>Die Höhen sind in %1, wie surface.height_unit sagt.</translation>
    </message>
    <message>
        <source>The file states no unit of heights: they are taken as metres.</source>
        <translation>Die Datei nennt keine Einheit der Höhen: sie gelten als Meter.</translation>
    </message>
    <message>
        <source>The file does not say how far its points are apart: %1 is assumed.</source>
        <translation>Die Datei sagt nicht, wie weit ihre Punkte auseinander liegen: %1 wird angenommen.</translation>
    </message>
    <message>
        <source>One point has no height.</source>
        <translation>Ein Punkt hat keine Höhe.</translation>
    </message>
    <message>
        <source>All heights are the same: the surface is flat.</source>
        <translation>Alle Höhen sind gleich: Die Oberfläche ist eben.</translation>
    </message>
    <message>
        <source>The height %1 (in %2) is far from all others: if it means a missing point, it has to be left empty, or surface.outliers has to be set.</source>
        <translation>Die Höhe %1 (in %2) liegt weit von allen anderen: Wenn sie für einen fehlenden Punkt steht, muss sie leer sein oder surface.outliers gesetzt werden.</translation>
    </message>
    <message>
        <source>The height %1 (in %2) stands %3 times, far from all others: if it means missing points, they have to be left empty, or surface.outliers has to be set.</source>
        <translation>Die Höhe %1 (in %2) steht %3-mal da, weit von allen anderen: Wenn sie für fehlende Punkte steht, müssen diese leer sein oder surface.outliers gesetzt werden.</translation>
    </message>
    <message>
        <source>Line %1 is left out: it begins with a number but is not a row of the table.</source>
        <translation>Zeile %1 bleibt weg: Sie beginnt mit einer Zahl und ist keine Zeile der Tabelle.</translation>
    </message>
    <message>
        <source>%1 lines, the first is line %2, are left out: they begin with a number but are not rows of the table.</source>
        <translation>%1 Zeilen, die erste ist Zeile %2, bleiben weg: Sie beginnen mit einer Zahl und sind keine Zeilen der Tabelle.</translation>
    </message>
    <message>
        <source>All numbers of a column have a '%1' before their last three digits and are read as thousands: '%2' is the decimal mark of the others.</source>
        <translation>Alle Zahlen einer Spalte haben ein '%1' vor den letzten drei Ziffern und werden als Tausender gelesen: '%2' ist das Dezimalzeichen der anderen.</translation>
    </message>
    <message>
        <source>All marks in the numbers stand before three digits: &apos;%1&apos; is taken for the decimal mark.</source>
        <translation>Alle Zeichen in den Zahlen stehen vor drei Ziffern: „%1“ gilt als Dezimalzeichen.</translation>
    </message>
    <message>
        <source>The points are as far apart as is stated: %1 numbers them.</source>
        <translation>Die Punkte sind so weit auseinander wie angegeben: %1 nummeriert sie.</translation>
    </message>
    <message>
        <source>line %1: %2 is not a height; a missing point is left empty or is NaN</source>
        <translation>Zeile %1: %2 ist keine Höhe; ein fehlender Punkt ist leer oder NaN</translation>
    </message>
    <message>
        <source>is a road file (%1), a kind that is not read; the heights of one track as text are, with their distance as surface.point_spacing</source>
        <translation>ist eine Straßendatei (%1), eine Art, die nicht gelesen wird; gelesen werden die Höhen einer Spur als Text, mit ihrem Abstand als surface.point_spacing</translation>
    </message>
    <message>
        <source>the positions are rounded to %1, too coarsely for even steps of %2: they need more digits, or the heights alone are read with surface.point_spacing</source>
        <translation>die Orte sind auf %1 gerundet, zu grob für gleiche Schritte von %2: Sie brauchen mehr Stellen, oder die Höhen allein werden mit surface.point_spacing gelesen</translation>
    </message>
    <message>
        <source>%1 points have no height.</source>
        <translation>%1 Punkte haben keine Höhe.</translation>
    </message>
    <message>
        <source>is %1; text (profiles, matrices, points) and files of these kinds are read: %2</source>
        <translation>ist %1; gelesen werden Text (Profile, Matrizen, Punkte) und Dateien dieser Arten: %2</translation>
    </message>
    <message>
        <source>has %1 x %2 points; at most %3 are read</source>
        <translation>hat %1 × %2 Punkte; höchstens %3 werden gelesen</translation>
    </message>
    <message>
        <source>ends too early: %1 x %2 points need %3 bytes, and %4 are there</source>
        <translation>endet zu früh: %1 × %2 Punkte brauchen %3 Bytes, und %4 sind da</translation>
    </message>
    <message>
        <source>the axis %1 is in &apos;%2&apos;, which is not a unit of length; %3 can name another one</source>
        <translation>die Achse %1 ist in „%2“, was keine Längeneinheit ist; %3 kann eine andere nennen</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>ist leer</translation>
    </message>
    <message>
        <source>is compressed, which %1 files are not read with</source>
        <translation>ist gepackt; gepackte %1-Dateien werden nicht gelesen</translation>
    </message>
    <message>
        <source>%1 in the header is not a number</source>
        <translation>%1 im Kopf ist keine Zahl</translation>
    </message>
    <message>
        <source>line %1: ends after %2 of %3 heights</source>
        <translation>Zeile %1: endet nach %2 von %3 Höhen</translation>
    </message>
    <message>
        <source>line %1: height %2 is not a number</source>
        <translation>Zeile %1: Höhe %2 ist keine Zahl</translation>
    </message>
    <message>
        <source>line %1: has more than the %2 heights that the header says</source>
        <translation>Zeile %1: hat mehr als die %2 Höhen, die der Kopf nennt</translation>
    </message>
    <message>
        <source>the packed heights of the %1 file cannot be unpacked</source>
        <translation>die gepackten Höhen der %1-Datei lassen sich nicht auspacken</translation>
    </message>
    <message>
        <source>has %1 bits a point; 16 or 32 are read</source>
        <translation>hat %1 Bit je Punkt; gelesen werden 16 oder 32</translation>
    </message>
    <message>
        <source>The first of %1 objects in the file is read.</source>
        <translation>Gelesen wird das erste von %1 Objekten in der Datei.</translation>
    </message>
    <message>
        <source>column %1</source>
        <translation>Spalte %1</translation>
    </message>
    <message>
        <source>column %1 &apos;%2&apos;</source>
        <translation>Spalte %1 „%2“</translation>
    </message>
    <message>
        <source>the file has %1 columns</source>
        <translation>die Datei hat %1 Spalten</translation>
    </message>
    <message>
        <source>is the column of the positions, too; they need one each</source>
        <translation>ist auch die Spalte der Orte; beide brauchen eine eigene</translation>
    </message>
    <message>
        <source>The first row and the first column are positions.</source>
        <translation>Die erste Zeile und die erste Spalte sind Orte.</translation>
    </message>
    <message>
        <source>the header says %1 x %2 pixels; the file has %3 x %4 numbers</source>
        <translation>der Kopf sagt %1 × %2 Pixel; die Datei hat %3 × %4 Zahlen</translation>
    </message>
    <message>
        <source>the header says %1 x %2 pixels and as many that mark those without a height; the file has %3 x %4 numbers</source>
        <translation>der Kopf sagt %1 × %2 Pixel und ebenso viele, die jene ohne Höhe kennzeichnen; die Datei hat %3 × %4 Zahlen</translation>
    </message>
    <message>
        <source>%1 is in &apos;%2&apos;, which is not a unit of length; %3 can name another one</source>
        <translation>%1 ist in „%2“, was keine Längeneinheit ist; %3 kann eine andere nennen</translation>
    </message>
    <message>
        <source>points need three columns: x, y and z</source>
        <translation>Punkte brauchen drei Spalten: x, y und z</translation>
    </message>
    <message>
        <source>the points do not lie on a grid of uniform rows and columns</source>
        <translation>die Punkte liegen auf keinem Gitter aus gleichabständigen Zeilen und Spalten</translation>
    </message>
    <message>
        <source>line %1: the position is missing</source>
        <translation>Zeile %1: der Ort fehlt</translation>
    </message>
    <message>
        <source>a file of Zygo</source>
        <translation>Datei von Zygo</translation>
    </message>
    <message>
        <source>a text file of Wyko</source>
        <translation>Textdatei von Wyko</translation>
    </message>
    <message>
        <source>a grid of Surfer</source>
        <translation>Gitter von Surfer</translation>
    </message>
    <message>
        <source>an array of NumPy</source>
        <translation>Array von NumPy</translation>
    </message>
    <message>
        <source>holds an array of %1 x %2 numbers; it should have heights alone, whose distance is surface.point_spacing</source>
        <translation>enthält ein Array von %1 × %2 Zahlen; es sollte nur Höhen haben, deren Abstand surface.point_spacing ist</translation>
    </message>
    <message>
        <source>is of version %1; 1 to 3 are read</source>
        <translation>ist von Version %1; gelesen werden 1 bis 3</translation>
    </message>
    <message>
        <source>has %1 bytes after its array</source>
        <translation>hat %1 Byte nach seinem Array</translation>
    </message>
    <message>
        <source>holds an array of the type %1; floating-point numbers of 4 or 8 bytes and whole numbers of 1 to 8 bytes are read</source>
        <translation>enthält ein Array des Typs %1; gelesen werden Gleitkommazahlen von 4 oder 8 Byte und ganze Zahlen von 1 bis 8 Byte</translation>
    </message>
    <message>
        <source>holds an array of %1 dimensions; heights have two, or one of a profile</source>
        <translation>enthält ein Array mit %1 Dimensionen; Höhen haben zwei, die eines Profils eine</translation>
    </message>
    <message>
        <source>is needed (%1): the unit &apos;%2&apos; of the file is not known; known are %3</source>
        <translation>wird gebraucht (%1): die Einheit „%2“ der Datei ist nicht bekannt; bekannt sind %3</translation>
    </message>
    <message>
        <source>surface.point_spacing is not used: the file says how far its points are apart.</source>
        <translation>surface.point_spacing wird nicht benutzt: Die Datei sagt, wie weit ihre Punkte auseinander liegen.</translation>
    </message>
    <message>
        <source>surface.point_spacing replaces the lengths above the numbers of the file.</source>
        <translation>surface.point_spacing ersetzt die Längen über den Zahlen der Datei.</translation>
    </message>
    <message>
        <source>one point without a height at an end is left out</source>
        <translation>ein Punkt ohne Höhe an einem Ende fällt weg</translation>
    </message>
    <message>
        <source>%1 points without a height at the ends are left out</source>
        <translation>%1 Punkte ohne Höhe an den Enden fallen weg</translation>
    </message>
    <message>
        <source>all heights of the row are the same: it has no spectrum</source>
        <translation>alle Höhen der Zeile sind gleich: sie hat kein Spektrum</translation>
    </message>
    <message>
        <source>one point of all rows stands far out of its neighbours, like a spike: where it is an error of the measurement, surface.outliers=%1 replaces it</source>
        <translation>ein Punkt aller Zeilen ragt weit aus seinen Nachbarn heraus, wie eine Spitze: wo er ein Messfehler ist, ersetzt ihn surface.outliers=%1</translation>
    </message>
    <message>
        <source>has one point along x; at least %1 are needed</source>
        <translation>hat einen Punkt entlang x; mindestens %1 werden gebraucht</translation>
    </message>
    <message>
        <source>line %1: has one field where the lines before have %2</source>
        <translation>Zeile %1: hat ein Feld, wo die Zeilen davor %2 haben</translation>
    </message>
    <message>
        <source>Positions are up to %1 % of a step off an even grid, on which they are taken.</source>
        <translation>Die Orte liegen bis zu %1 % eines Schritts neben einem gleichmäßigen Gitter, auf dem sie genommen werden.</translation>
    </message>
    <message>
        <source>Blank lines separate %1 tables; the first one, up to line %2, is read.</source>
        <translation>Leerzeilen trennen %1 Tabellen; gelesen wird die erste, bis Zeile %2.</translation>
    </message>
    <message>
        <source>The file has %1 profiles, which are the rows of the surface: surface.row chooses one.</source>
        <translation>Die Datei hat %1 Profile, welche die Zeilen der Oberfläche sind: surface.row wählt eines.</translation>
    </message>
    <message>
        <source>The file has %1 profiles side by side, %2 to %3, which are the rows of the surface: surface.row chooses one.</source>
        <translation>Die Datei hat %1 Profile nebeneinander, %2 bis %3, welche die Zeilen der Oberfläche sind: surface.row wählt eines.</translation>
    </message>
    <message>
        <source>%1 is left out: a height is missing in its first or its last row.</source>
        <translation>%1 wird ausgelassen: In der ersten oder letzten Zeile fehlt eine Höhe.</translation>
    </message>
    <message>
        <source>Blank lines stand between the rows, the first one above line %1: all rows are taken for one table.</source>
        <translation>Zwischen den Zeilen stehen Leerzeilen, die erste über Zeile %1: Alle Zeilen gelten als eine Tabelle.</translation>
    </message>
    <message>
        <source>is needed: blank lines separate %1 parts of %2 rows; say matrix where they are one, and leave only one of them in the file where they are several</source>
        <translation>wird gebraucht: Leerzeilen trennen %1 Teile mit je %2 Zeilen; matrix angeben, wenn sie eine sind, und nur einen davon in der Datei lassen, wenn sie mehrere sind</translation>
    </message>
    <message>
        <source>The points are as far apart as the speed and the sampling rate of the header say.</source>
        <translation>Die Punkte sind so weit voneinander entfernt, wie Geschwindigkeit und Abtastrate im Kopf es sagen.</translation>
    </message>
    <message>
        <source>The points are as far apart as their first and last position in the header say.</source>
        <translation>Die Punkte sind so weit voneinander entfernt, wie ihre erste und letzte Position im Kopf es sagen.</translation>
    </message>
    <message>
        <source>The header states one length without an axis: rows are taken to be as far apart as points.</source>
        <translation>Der Kopf nennt eine Länge ohne Achse: der Abstand der Zeilen wird gleich dem der Punkte angenommen.</translation>
    </message>
    <message>
        <source>The header states the length along y alone: points are taken to be as far apart as rows.</source>
        <translation>Der Kopf nennt nur die Länge längs y: Für die Punkte wird der Abstand der Zeilen angenommen.</translation>
    </message>
    <message>
        <source>is needed (%1): the numbers are named &apos;%2&apos;, which are no heights</source>
        <translation>wird gebraucht (%1): die Zahlen heißen „%2“, was keine Höhen sind</translation>
    </message>
    <message>
        <source>The numbers are named &apos;%1&apos;, which are no heights: they are taken as such all the same.</source>
        <translation>Die Zahlen heißen „%1“, was keine Höhen sind: Sie werden trotzdem dafür genommen.</translation>
    </message>
    <message>
        <source>The header states %1 for positions, and their column %2, which is taken.</source>
        <translation>Der Kopf nennt %1 für die Orte und ihre Spalte %2; es gilt die Spalte.</translation>
    </message>
    <message>
        <source>The header states %1 for heights, and their column %2, which is taken.</source>
        <translation>Der Kopf nennt %1 für die Höhen und ihre Spalte %2; es gilt die Spalte.</translation>
    </message>
    <message>
        <source>The header states a step of %1, and the positions are %2 apart: the positions are taken.</source>
        <translation>Der Kopf nennt einen Schritt von %1, und die Orte liegen %2 auseinander: Es gelten die Orte.</translation>
    </message>
    <message>
        <source>The file states positions in %1: surface.position_unit replaces it.</source>
        <translation>Die Datei nennt die Orte in %1: surface.position_unit ersetzt das.</translation>
    </message>
    <message>
        <source>The file states heights in %1: surface.height_unit replaces it.</source>
        <translation>Die Datei nennt die Höhen in %1: surface.height_unit ersetzt das.</translation>
    </message>
    <message>
        <source>One row repeats a position: the mean of the heights is taken.</source>
        <translation>Eine Zeile wiederholt einen Ort: Der Mittelwert der Höhen gilt.</translation>
    </message>
    <message>
        <source>One place has no row in the file and is taken as a gap.</source>
        <translation>Eine Stelle hat keine Zeile in der Datei und gilt als Lücke.</translation>
    </message>
    <message>
        <source>%1 numbers the points.</source>
        <translation>%1 nummeriert die Punkte.</translation>
    </message>
    <message>
        <source>is needed (in m): lines %1 and %2 state different lengths of one axis</source>
        <translation>wird gebraucht (in m): Die Zeilen %1 und %2 nennen verschiedene Längen für eine Achse</translation>
    </message>
    <message>
        <source>the header states %1 rows of %2 points; the file has %3 heights in one column</source>
        <translation>der Kopf nennt %1 Zeilen zu %2 Punkten; die Datei hat %3 Höhen in einer Spalte</translation>
    </message>
    <message>
        <source>The rows follow each other in one column; the header states their length.</source>
        <translation>Die Zeilen folgen einander in einer Spalte; der Kopf nennt ihre Länge.</translation>
    </message>
    <message>
        <source>The header states a factor of %1 (%2), which is not applied: multiply the numbers of the file where they have to be.</source>
        <translation>Der Kopf nennt einen Faktor von %1 (%2), der nicht angewandt wird: Die Zahlen der Datei sind damit zu multiplizieren, wo sie es sein müssen.</translation>
    </message>
    <message>
        <source>The header states %1 points, and the table has %2: the file may be cut off.</source>
        <translation>Der Kopf nennt %1 Punkte, und die Tabelle hat %2: Die Datei ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>The header states %1 x %2 points, and the table has %3 x %4: the file may be cut off.</source>
        <translation>Der Kopf nennt %1 × %2 Punkte, und die Tabelle hat %3 × %4: Die Datei ist vielleicht abgeschnitten.</translation>
    </message>
    <message>
        <source>is needed (in m): the file states a step of %1 and an extent of %2, which do not fit %3 points</source>
        <translation>wird gebraucht (in m): Die Datei nennt einen Schritt von %1 und eine Ausdehnung von %2, die nicht zu %3 Punkten passen</translation>
    </message>
    <message>
        <source>is needed: the first row may number the points; leave it out, or set matrix where it holds heights</source>
        <translation>wird gebraucht: Die erste Zeile kann die Punkte nummerieren; lassen Sie sie weg, oder setzen Sie matrix, wenn sie Höhen enthält</translation>
    </message>
    <message>
        <source>is needed: the first column may number the points; leave it out, or set matrix where it holds heights</source>
        <translation>wird gebraucht: Die erste Spalte kann die Punkte nummerieren; lassen Sie sie weg, oder setzen Sie matrix, wenn sie Höhen enthält</translation>
    </message>
    <message>
        <source>is needed: the first row is evenly spaced and may hold positions; leave it out, or set matrix where it holds heights</source>
        <translation>wird gebraucht: Die erste Zeile hat gleiche Abstände und kann Orte enthalten; lassen Sie sie weg, oder setzen Sie matrix, wenn sie Höhen enthält</translation>
    </message>
    <message>
        <source>is needed: the first column is evenly spaced and may hold positions; leave it out, or set matrix where it holds heights</source>
        <translation>wird gebraucht: Die erste Spalte hat gleiche Abstände und kann Orte enthalten; lassen Sie sie weg, oder setzen Sie matrix, wenn sie Höhen enthält</translation>
    </message>
    <message>
        <source>The first row and the first column are evenly spaced and are taken as positions; the number %1 in the corner is left out.</source>
        <translation>Die erste Zeile und die erste Spalte haben gleiche Abstände und gelten als Orte; die Zahl %1 in der Ecke bleibt weg.</translation>
    </message>
    <message>
        <source>The first row and the first column number the points.</source>
        <translation>Die erste Zeile und die erste Spalte nummerieren die Punkte.</translation>
    </message>
    <message>
        <source>The first row numbers the points.</source>
        <translation>Die erste Zeile nummeriert die Punkte.</translation>
    </message>
    <message>
        <source>The first column numbers the points.</source>
        <translation>Die erste Spalte nummeriert die Punkte.</translation>
    </message>
    <message>
        <source>the axes %1 and %2 have %3 and %4 points</source>
        <translation>die Achsen %1 und %2 haben %3 und %4 Punkte</translation>
    </message>
    <message>
        <source>has an axis CY; of SMD and PRF files profiles with CX and CZ are read</source>
        <translation>hat eine Achse CY; von SMD und PRF werden Profile mit CX und CZ gelesen</translation>
    </message>
    <message>
        <source>the number of points of an axis is not a whole number from 1 to %1</source>
        <translation>die Anzahl der Punkte einer Achse ist keine ganze Zahl von 1 bis %1</translation>
    </message>
    <message>
        <source>line %1: has %2 numbers for %3 points</source>
        <translation>Zeile %1: hat %2 Zahlen für %3 Punkte</translation>
    </message>
    <message>
        <source>has no block of heights; known are %1</source>
        <translation>hat keinen Block von Höhen; bekannt sind %1</translation>
    </message>
    <message>
        <source>line %1: number %2 is missing</source>
        <translation>Zeile %1: Zahl %2 fehlt</translation>
    </message>
    <message>
        <source>line %1: number %2 is not a whole number from 0 to %3</source>
        <translation>Zeile %1: Zahl %2 ist keine ganze Zahl von 0 bis %3</translation>
    </message>
    <message>
        <source>line %1: is not a point &apos;x y z&apos;</source>
        <translation>Zeile %1: ist kein Punkt „x y z“</translation>
    </message>
    <message>
        <source>line %1: the pixel %2 %3 is not in the field that line 4 says</source>
        <translation>Zeile %1: das Pixel %2 %3 liegt nicht in dem Feld, das Zeile 4 nennt</translation>
    </message>
    <message>
        <source>line %1: the height is not a number</source>
        <translation>Zeile %1: die Höhe ist keine Zahl</translation>
    </message>
    <message>
        <source>line %1: %2 in the header is not a number</source>
        <translation>Zeile %1: %2 im Kopf ist keine Zahl</translation>
    </message>
    <message>
        <source>the positions leap from %1 to %2, %3 times the usual step; each part needs a file of its own</source>
        <translation>die Orte springen von %1 nach %2, um das %3-Fache des üblichen Schritts; jeder Abschnitt braucht eine eigene Datei</translation>
    </message>
    <message>
        <source>line %1: there is a point at this position already</source>
        <translation>Zeile %1: an diesem Ort gibt es schon einen Punkt</translation>
    </message>
    <message>
        <source>has no column of heights</source>
        <translation>hat keine Spalte mit Höhen</translation>
    </message>
    <message>
        <source>%1 says which points are valid; the others are gaps.</source>
        <translation>%1 sagt, welche Punkte gültig sind; die anderen sind Lücken.</translation>
    </message>
    <message>
        <source>Heights are %1, one of %2 columns that could be; surface.height_column chooses another.</source>
        <translation>Höhen sind %1, eine von %2 möglichen Spalten; surface.height_column wählt eine andere.</translation>
    </message>
    <message>
        <source>%1 tables of the file follow each other along x: they are read as one.</source>
        <translation>%1 Tabellen der Datei setzen einander längs x fort: Sie werden als eine gelesen.</translation>
    </message>
    <message>
        <source>The file turns its axes (Rotation in main.xml). The program does not: it takes heights and positions as they are stored.</source>
        <translation>Die Datei dreht ihre Achsen (Rotation in main.xml). Das Programm dreht sie nicht: Es nimmt Höhen und Orte, wie sie gespeichert sind.</translation>
    </message>
    <message>
        <source>Turned so, its heights would count downwards: surface.contact_side valleys then chooses the summits.</source>
        <translation>So gedreht würden ihre Höhen nach unten zählen: surface.contact_side valleys wählt dann die Gipfel.</translation>
    </message>
    <message>
        <source>Line %1 is left out: it is the number of the heights below it.</source>
        <translation>Zeile %1 bleibt weg: Sie ist die Anzahl der Höhen darunter.</translation>
    </message>
    <message>
        <source>The file has %1 tables of numbers; that of heights, from line %2 on, is read.</source>
        <translation>Die Datei hat %1 Zahlentabellen; gelesen wird die der Höhen, ab Zeile %2.</translation>
    </message>
    <message>
        <source>The file has %1 tables of numbers; the first of %2 equally large ones, from line %3 on, is read.</source>
        <translation>Die Datei hat %1 Zahlentabellen; gelesen wird die erste von %2 gleich großen, ab Zeile %3.</translation>
    </message>
    <message>
        <source>The file has %1 tables of numbers; the largest one, from line %2 on, is read.</source>
        <translation>Die Datei hat %1 Zahlentabellen; gelesen wird die größte, ab Zeile %2.</translation>
    </message>
    <message>
        <source>%1 places have no row in the file and are taken as gaps.</source>
        <translation>%1 Orte haben keine Zeile in der Datei und gelten als Lücken.</translation>
    </message>
    <message>
        <source>Positions have few digits (steps differ by up to %1 %) and are taken for uniform ones that were rounded.</source>
        <translation>Die Orte haben wenige Stellen (die Schritte weichen um bis zu %1 % ab) und gelten als gleichabständige, die gerundet wurden.</translation>
    </message>
    <message>
        <source>Positions are not uniform (steps differ by up to %1 %): heights are interpolated linearly onto %2 uniform places.</source>
        <translation>Die Orte sind nicht gleichabständig (die Schritte weichen um bis zu %1 % ab): die Höhen werden linear auf %2 gleichabständige Orte umgerechnet.</translation>
    </message>
    <message>
        <source>Positions fall from row to row: the profile is turned round.</source>
        <translation>Die Orte fallen von Zeile zu Zeile: das Profil wird umgedreht.</translation>
    </message>
    <message>
        <source>line %1: the position goes back; positions must rise or fall all along</source>
        <translation>Zeile %1: der Ort springt zurück; Orte müssen durchweg steigen oder durchweg fallen</translation>
    </message>
    <message>
        <source>%1 rows repeat a position: the mean of their heights is taken.</source>
        <translation>%1 Zeilen wiederholen einen Ort: es gilt der Mittelwert ihrer Höhen.</translation>
    </message>
    <message>
        <source>all positions are the same; at least 3 different ones are needed</source>
        <translation>alle Orte sind gleich; mindestens 3 verschiedene sind nötig</translation>
    </message>
    <message>
        <source>is not a whole %1 archive</source>
        <translation>ist kein vollständiges %1-Archiv</translation>
    </message>
    <message>
        <source>has no file &apos;%1&apos; in its archive</source>
        <translation>hat in seinem Archiv keine Datei „%1“</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in its archive is larger than the %2 bytes allowed</source>
        <translation>„%1“ im Archiv ist größer als die erlaubten %2 Bytes</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in its archive cannot be unpacked</source>
        <translation>„%1“ im Archiv lässt sich nicht auspacken</translation>
    </message>
    <message>
        <source>main.xml has no %1</source>
        <translation>in main.xml fehlt %1</translation>
    </message>
    <message>
        <source>main.xml: %1 is neither %2</source>
        <translation>main.xml: %1 ist nichts von %2</translation>
    </message>
    <message>
        <source>main.xml: %1 is not a number</source>
        <translation>main.xml: %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>main.xml: %1 is not a number above 0</source>
        <translation>main.xml: %1 ist keine Zahl über 0</translation>
    </message>
    <message>
        <source>is a cloud of points (PCL); only profiles and surfaces on a grid are read</source>
        <translation>ist eine Punktwolke (PCL); gelesen werden nur Profile und Flächen auf einem Gitter</translation>
    </message>
    <message>
        <source>main.xml: byte %1: is not valid XML</source>
        <translation>main.xml: Byte %1: ist kein gültiges XML</translation>
    </message>
    <message>
        <source>&apos;%1&apos; in its archive does not have the MD5 that the file states</source>
        <translation>„%1“ im Archiv hat nicht die MD5, die die Datei nennt</translation>
    </message>
    <message>
        <source>The first of %1 layers is read.</source>
        <translation>Gelesen wird die erste von %1 Schichten.</translation>
    </message>
    <message>
        <source>is a list of points without a grid; only profiles and surfaces on a grid are read</source>
        <translation>ist eine Liste von Punkten ohne Gitter; gelesen werden nur Profile und Flächen auf einem Gitter</translation>
    </message>
    <message>
        <source>main.xml: datum %1 has %2 numbers where %3 are needed</source>
        <translation>main.xml: Datum %1 hat %2 Zahlen, gebraucht werden %3</translation>
    </message>
    <message>
        <source>main.xml: datum %1 is not a number</source>
        <translation>main.xml: Datum %1 ist keine Zahl</translation>
    </message>
    <message>
        <source>main.xml: has %1 points where %2 are needed</source>
        <translation>main.xml: hat %1 Punkte, gebraucht werden %2</translation>
    </message>
    <message>
        <source>the positions along %1 are not uniform; surfaces need a uniform grid</source>
        <translation>die Orte längs %1 sind nicht gleichabständig; Flächen brauchen ein gleichabständiges Gitter</translation>
    </message>
    <message>
        <source>there is one frequency alone at %1, %2 Hz; a shift needs sweeps of at least two frequencies at each temperature (--temperature-tolerance says how far the rows of one sweep may lie apart)</source>
        <translation>bei %1 gibt es nur eine Frequenz, %2 Hz; eine Verschiebung braucht mindestens zwei Frequenzen bei jeder Temperatur (--temperature-tolerance sagt, wie weit die Zeilen einer Messreihe auseinanderliegen dürfen)</translation>
    </message>
    <message>
        <source>holds no row of frequency and moduli</source>
        <translation>enthält keine Zeile mit Frequenz und Moduln</translation>
    </message>
    <message>
        <source>runs from %1 to %2 without a gap of more than %3 K; sweeps at constant temperatures are needed (--temperature-tolerance says how far the rows of one sweep may lie apart)</source>
        <translation>läuft von %1 bis %2 ohne eine Lücke von mehr als %3 K; nötig sind Messungen bei festen Temperaturen (--temperature-tolerance sagt, wie weit die Zeilen einer Messung auseinanderliegen dürfen)</translation>
    </message>
    <message>
        <source>temperature %1 with frequency within %2 of %3 sweeps, by up to %4 K (%5 to %6, now the isotherm at %7): their moduli are interpolated at each frequency between neighbouring sweeps to one temperature</source>
        <translation>die Temperatur %1 mit der Frequenz innerhalb von %2 der %3 Messungen, um bis zu %4 K (%5 bis %6, nun die Isotherme bei %7): ihre Moduln sind bei jeder Frequenz zwischen benachbarten Messungen auf eine Temperatur interpoliert</translation>
    </message>
    <message>
        <source>temperature %1 with frequency within %2 of %3 sweeps, by up to %4 K (%5 to %6, taken for %7), which distorts their moduli and shifts; wait for a steady temperature, or measure the same frequencies at temperatures below and above, between which they can be interpolated</source>
        <translation>die Temperatur %1 mit der Frequenz innerhalb von %2 der %3 Messungen, um bis zu %4 K (%5 bis %6, als %7 gelesen), was ihre Moduln und Verschiebungen verfälscht; eine stetige Temperatur abwarten oder dieselben Frequenzen bei Temperaturen darunter und darüber messen, zwischen denen sich interpolieren lässt</translation>
    </message>
    <message>
        <source>rises</source>
        <translation>steigt</translation>
    </message>
    <message>
        <source>falls</source>
        <translation>fällt</translation>
    </message>
    <message>
        <source>the isotherms at %1 and %2 do not overlap: no shift brings their moduli together; a sweep at a temperature between them or over more frequencies is needed, or leave the isotherms beyond the gap out</source>
        <translation>die Isothermen bei %1 und %2 überlappen nicht: keine Verschiebung bringt ihre Moduln zusammen; nötig ist eine Messung bei einer Temperatur dazwischen oder über mehr Frequenzen, oder die Isothermen jenseits der Lücke weglassen</translation>
    </message>
    <message>
        <source>the isotherm at %1 is slower than that at %2 by %3 decades: the temperatures are out of order, or the moduli change too little to tell; correct the column, or leave an isotherm out</source>
        <translation>die Isotherme bei %1 ist um %3 Dekaden langsamer als die bei %2: die Temperaturen sind vertauscht, oder die Moduln ändern sich zu wenig, um es zu sagen; die Spalte berichtigen oder eine Isotherme weglassen</translation>
    </message>
    <message>
        <source>holds no isotherm</source>
        <translation>enthält keine Isotherme</translation>
    </message>
    <message>
        <source>%1 K is outside of the measured temperatures, %2 to %3 K (%4 to %5); a temperature may be written as 20C</source>
        <translation>%1 K liegt außerhalb der gemessenen Temperaturen, %2 bis %3 K (%4 bis %5); eine Temperatur darf als 20C geschrieben werden</translation>
    </message>
    <message>
        <source>has one value alone; a series needs a range of frequencies</source>
        <translation>hat nur einen Wert; eine Reihe braucht einen Bereich von Frequenzen</translation>
    </message>
    <message>
        <source>%1 is outside 1 to %2, what %3 points can tell</source>
        <translation>%1 liegt außerhalb von 1 bis %2, was %3 Punkte hergeben</translation>
    </message>
    <message>
        <source>is 0 in the fit: down to %1 Hz the storage modulus still falls as that of a liquid, which cannot carry a load for ever; measure at lower frequencies or higher temperatures, give --equilibrium-modulus, or allow it with --liquid</source>
        <translation>ist 0 in der Anpassung: bis %1 Hz hinab fällt der Speichermodul wie der einer Flüssigkeit, die keine Last auf Dauer trägt; bei tieferen Frequenzen oder höheren Temperaturen messen, --equilibrium-modulus angeben oder es mit --liquid erlauben</translation>
    </message>
    <message>
        <source>is %1 in the fit, where the smallest storage modulus is %2, and cannot be told from 0: a liquid fits as well, which cannot carry a load for ever; measure at lower frequencies or higher temperatures, give --equilibrium-modulus, or allow it with --liquid</source>
        <translation>ist %1 in der Anpassung, wo der kleinste Speichermodul %2 ist, und lässt sich von 0 nicht unterscheiden: eine Flüssigkeit passt ebenso gut, die auf Dauer keine Last trägt; bei tieferen Frequenzen oder höheren Temperaturen messen, --equilibrium-modulus angeben oder es mit --liquid zulassen</translation>
    </message>
    <message>
        <source>needs a number in place %1</source>
        <translation>braucht eine Zahl an Stelle %1</translation>
    </message>
    <message>
        <source>keywords of Abaqus</source>
        <translation>Schlüsselwörter von Abaqus</translation>
    </message>
    <message>
        <source>has a hyperelastic form whose shear modulus is not read; NEO HOOKE, MOONEY-RIVLIN, YEOH, POLYNOMIAL (N=1), REDUCED POLYNOMIAL (N=1 to 3) and OGDEN (N=1 or 2) with their constants are, or give --equilibrium-modulus</source>
        <translation>hat eine hyperelastische Form, deren Schubmodul nicht gelesen wird; NEO HOOKE, MOONEY-RIVLIN, YEOH, POLYNOMIAL (N=1), REDUCED POLYNOMIAL (N=1 bis 3) und OGDEN (N=1 oder 2) mit ihren Konstanten werden es, oder --equilibrium-modulus angeben</translation>
    </message>
    <message>
        <source>is neither TIME=PRONY nor FREQUENCY=PRONY; a table of frequencies and moduli is read as such</source>
        <translation>ist weder TIME=PRONY noch FREQUENCY=PRONY; eine Tabelle von Frequenzen und Moduln wird als solche gelesen</translation>
    </message>
    <message>
        <source>is a second *VISCOELASTIC; keep the material that is meant alone</source>
        <translation>ist ein zweites *VISCOELASTIC; nur das gemeinte Material stehen lassen</translation>
    </message>
    <message>
        <source>commands of Ansys</source>
        <translation>Befehle von Ansys</translation>
    </message>
    <message>
        <source>begins at a place that is outside 1 to 200</source>
        <translation>beginnt an einer Stelle außerhalb von 1 bis 200</translation>
    </message>
    <message>
        <source>a table of relaxation times and moduli</source>
        <translation>eine Tabelle von Relaxationszeiten und Moduln</translation>
    </message>
    <message>
        <source>holds no relaxation time</source>
        <translation>enthält keine Relaxationszeit</translation>
    </message>
    <message>
        <source>holds no term of a Prony series</source>
        <translation>enthält kein Glied einer Prony-Reihe</translation>
    </message>
    <message>
        <source>has %1 terms; allowed is %2</source>
        <translation>hat %1 Glieder; erlaubt sind %2</translation>
    </message>
    <message>
        <source>the modulus is %1, which must be at least 0</source>
        <translation>der Modul ist %1 und muss mindestens 0 sein</translation>
    </message>
    <message>
        <source>the relaxation time is %1 s, which must be above 0 and at most %2 s</source>
        <translation>die Relaxationszeit ist %1 s und muss über 0 und darf höchstens %2 s sein</translation>
    </message>
    <message>
        <source>the parts of the instantaneous modulus add up to %1, more than 1</source>
        <translation>die Teile des Momentanmoduls ergeben zusammen %1, mehr als 1</translation>
    </message>
    <message>
        <source>has parts of a modulus and not the modulus itself; give the instantaneous shear modulus with --instantaneous-modulus, or --equilibrium-modulus</source>
        <translation>hat Teile eines Moduls und nicht den Modul selbst; den Momentan-Schubmodul mit --instantaneous-modulus angeben, oder --equilibrium-modulus</translation>
    </message>
    <message>
        <source>%1 has no unit: %2 is assumed, which fits the other moduli</source>
        <translation>%1 hat keine Einheit: angenommen ist %2, was zu den anderen Moduln passt</translation>
    </message>
    <message>
        <source>has no unit, and %1 is in %2; write its unit after the number</source>
        <translation>hat keine Einheit, und %1 ist in %2; die Einheit hinter die Zahl schreiben</translation>
    </message>
    <message>
        <source>the moduli contradict each other: the arms leave %1 MPa of the instantaneous modulus, and an equilibrium modulus of %2 MPa is stated, which is taken</source>
        <translation>die Moduln widersprechen sich: die Arme lassen vom Momentanmodul %1 MPa übrig, und angegeben ist ein Gleichgewichtsmodul von %2 MPa, der genommen wird</translation>
    </message>
    <message>
        <source>has parts that add up to 1, so that its long-term modulus is 0; give --instantaneous-modulus, and --liquid if that is meant</source>
        <translation>hat Teile, die zusammen 1 ergeben, so dass der Langzeitmodul 0 ist; --instantaneous-modulus angeben, und --liquid, wenn das gemeint ist</translation>
    </message>
    <message>
        <source>is not above 0, as of a liquid, which cannot carry a load for ever; give --equilibrium-modulus, or allow it with --liquid</source>
        <translation>ist nicht über 0, wie bei einer Flüssigkeit, die keine Last auf Dauer trägt; --equilibrium-modulus angeben oder es mit --liquid erlauben</translation>
    </message>
    <message>
        <source>the moduli are at most %1 Pa, which is softer than any rubber: where the file states a wrong unit, --modulus-unit replaces it</source>
        <translation>die Moduln sind höchstens %1 Pa, weicher als jedes Gummi: Nennt die Datei eine falsche Einheit, ersetzt sie --modulus-unit</translation>
    </message>
    <message>
        <source>the moduli are at least %1 Pa, which is stiffer than any rubber: where the file states a wrong unit, --modulus-unit replaces it</source>
        <translation>die Moduln sind mindestens %1 Pa, steifer als jedes Gummi: Nennt die Datei eine falsche Einheit, ersetzt sie --modulus-unit</translation>
    </message>
    <message>
        <source>equilibrium was not measured: at the lowest frequency, %1, the storage modulus is %2 times G∞</source>
        <translation>das Gleichgewicht wurde nicht gemessen: Bei der niedrigsten Frequenz, %1, ist der Speichermodul das %2-Fache von G∞</translation>
    </message>
    <message>
        <source>%1 stands in the first row of each group alone: it holds for the rows below it</source>
        <translation>%1 steht nur in der ersten Zeile jeder Gruppe: Der Wert gilt für die Zeilen darunter</translation>
    </message>
    <message>
        <source>has no unit, and %1 Pa would be no rubber; say --modulus-unit MPa or another one</source>
        <translation>hat keine Einheit, und %1 Pa wären kein Gummi; --modulus-unit MPa oder eine andere angeben</translation>
    </message>
    <message>
        <source>holds no row with a frequency and both moduli</source>
        <translation>enthält keine Zeile mit einer Frequenz und beiden Moduln</translation>
    </message>
    <message>
        <source>has no columns that are known as frequency, storage and loss modulus (or tan delta, or magnitude and phase) among %1; say which they are with --frequency-column, --storage-column and --loss-column</source>
        <translation>hat unter %1 keine Spalten, die als Frequenz, Speicher- und Verlustmodul (oder tan delta, oder Betrag und Phase) bekannt sind; mit --frequency-column, --storage-column und --loss-column sagen, welche es sind</translation>
    </message>
    <message>
        <source>has the unit %1, which is not one of %2; %3 says which is meant</source>
        <translation>hat die Einheit %1, die keine von %2 ist; %3 sagt, welche gemeint ist</translation>
    </message>
    <message>
        <source>is of another kind than the other modulus: one is of shear (G), one of tension (E); say with --storage-column and --loss-column which belong together</source>
        <translation>ist von anderer Art als der andere Modul: einer ist von Schub (G), einer von Zug (E); mit --storage-column und --loss-column sagen, welche zusammengehören</translation>
    </message>
    <message>
        <source>may be of shear (G) or of tension (E); say which with --modulus shear or --modulus tension</source>
        <translation>kann von Schub (G) oder von Zug (E) sein; mit --modulus shear oder --modulus tension sagen, welcher</translation>
    </message>
    <message>
        <source>runs from %1 to %2 without a unit: kelvins and degrees Celsius seem to be mixed; say which with --temperature-unit, or correct the column</source>
        <translation>läuft von %1 bis %2 ohne Einheit: Kelvin und Grad Celsius scheinen gemischt; mit --temperature-unit sagen, welche, oder die Spalte berichtigen</translation>
    </message>
    <message>
        <source>%1 runs from %2 to %3 °C, where most rubbers are destroyed; these look like kelvins: say --temperature-unit K if they are</source>
        <translation>%1 läuft von %2 bis %3 °C, wo die meisten Gummis zerstört sind; das sieht nach Kelvin aus: --temperature-unit K angeben, falls es welche sind</translation>
    </message>
    <message>
        <source>is stated nowhere; say at which the moduli were measured with --temperature, such as --temperature 20C</source>
        <translation>steht nirgends; mit --temperature sagen, bei welcher die Moduln gemessen wurden, etwa --temperature 20C</translation>
    </message>
    <message>
        <source>is stated nowhere; say at which the moduli were measured with --temperature, such as --temperature 20C (line %1 may be about something else: %2)</source>
        <translation>steht nirgends; mit --temperature sagen, bei welcher die Moduln gemessen wurden, etwa --temperature 20C (Zeile %1 handelt vielleicht von etwas anderem: %2)</translation>
    </message>
    <message>
        <source>line %1 says of which kind the moduli are: %2</source>
        <translation>Zeile %1 sagt, welcher Art die Moduln sind: %2</translation>
    </message>
    <message>
        <source>the column %1 says that the moduli are of shear</source>
        <translation>die Spalte %1 sagt, dass es Schubmoduln sind</translation>
    </message>
    <message>
        <source>the column %1 says that the moduli are of tension</source>
        <translation>die Spalte %1 sagt, dass es Zugmoduln sind</translation>
    </message>
    <message>
        <source>the file has moduli of tension (E) by their names: %1; without the option they are read as such and divided for shear; where the names are wrong, say with --storage-column and --loss-column which are meant</source>
        <translation>die Datei hat den Namen nach Zugmoduln (E): %1; ohne die Option werden sie als solche gelesen und für Schub geteilt; wo die Namen falsch sind, mit --storage-column und --loss-column sagen, welche gemeint sind</translation>
    </message>
    <message>
        <source>the file has moduli of shear (G) by their names: %1; without the option they are read as such; where the names are wrong, say with --storage-column and --loss-column which are meant</source>
        <translation>die Datei hat den Namen nach Schubmoduln (G): %1; ohne die Option werden sie als solche gelesen; wo die Namen falsch sind, mit --storage-column und --loss-column sagen, welche gemeint sind</translation>
    </message>
    <message>
        <source>%1 is not above %2, which is a part of it; leave the row out or correct it</source>
        <translation>%1 liegt nicht über %2, einem Teil davon; die Zeile weglassen oder berichtigen</translation>
    </message>
    <message>
        <source>the other modulus follows from %1 and %2, which differ little: 1 % of error in one of them makes %3 % in it, in the median</source>
        <translation>der andere Modul folgt aus %1 und %2, die sich wenig unterscheiden: 1 % Fehler in einem davon macht im Median %3 % in ihm</translation>
    </message>
    <message>
        <source>and %1 are a compliance and none; both moduli follow from two compliances, or from two moduli</source>
        <translation>und %1 sind eine Nachgiebigkeit und keine; beide Moduln folgen aus zwei Nachgiebigkeiten oder aus zwei Moduln</translation>
    </message>
    <message>
        <source>the moduli follow from compliances: G* = 1 / J*</source>
        <translation>die Moduln folgen aus Nachgiebigkeiten: G* = 1 / J*</translation>
    </message>
    <message>
        <source>the moduli follow from viscosities: G* = i ω η*</source>
        <translation>die Moduln folgen aus Viskositäten: G* = i ω η*</translation>
    </message>
    <message>
        <source>%1: the imaginary parts are below 0 in all rows, by a convention of signs; their magnitude is taken</source>
        <translation>%1: die Imaginärteile liegen in allen Zeilen unter 0, nach einer Vorzeichenregel; ihr Betrag wird genommen</translation>
    </message>
    <message>
        <source>line %1: is not a complex number, as others of the column are</source>
        <translation>Zeile %1: ist keine komplexe Zahl, wie andere der Spalte es sind</translation>
    </message>
    <message>
        <source>errors in cells, not read, because every point counts the same: %1</source>
        <translation>Fehler in Zellen, nicht gelesen, weil jeder Punkt gleich viel zählt: %1</translation>
    </message>
    <message>
        <source>the table has one row for each quantity, and its columns are the points</source>
        <translation>die Tabelle hat eine Zeile für jede Größe, und ihre Spalten sind die Punkte</translation>
    </message>
    <message>
        <source>the temperature rises or falls slowly at each of %1 frequencies: their moduli are interpolated to isotherms %2 K apart</source>
        <translation>die Temperatur steigt oder fällt langsam bei jeder von %1 Frequenzen: ihre Moduln werden zwischen den Temperaturen auf Isothermen im Abstand von %2 K interpoliert</translation>
    </message>
    <message>
        <source>ramps of temperature at one frequency, beside the sweeps: %1 rows are not used</source>
        <translation>Temperaturrampen bei einer Frequenz neben den Frequenzgängen: %1 Zeilen werden nicht verwendet</translation>
    </message>
    <message>
        <source>has no unit and adds up to %1; parts of the instantaneous modulus add up to at most 1, and moduli need their unit: correct the parts, or say with --modulus-unit which unit the moduli have</source>
        <translation>hat keine Einheit und ergibt zusammen %1; Anteile des Anfangsmoduls ergeben zusammen höchstens 1, und Moduln brauchen ihre Einheit: die Anteile berichtigen oder mit --modulus-unit sagen, welche Einheit die Moduln haben</translation>
    </message>
    <message>
        <source>tells samples or runs apart, %1 in line %2 and %3 in line %4, whose moduli at the same temperature and frequency differ by a factor of %5 in the median; keep the rows of one of them</source>
        <translation>unterscheidet Proben oder Läufe, %1 in Zeile %2 und %3 in Zeile %4, deren Moduln bei gleicher Temperatur und Frequenz im Median um den Faktor %5 auseinander liegen; die Zeilen von einem davon behalten</translation>
    </message>
    <message>
        <source>states other moduli at the same temperature and frequency, as in lines %1 and %2, by a factor of %3 in the median, and runs of one sample differ by at most %4; keep the rows of one sample and run (columns that are not read: %5)</source>
        <translation>nennt bei gleicher Temperatur und Frequenz andere Moduln, wie in den Zeilen %1 und %2, im Median um den Faktor %3, und Läufe einer Probe unterscheiden sich um höchstens %4; die Zeilen von einer Probe und einem Lauf behalten (nicht gelesene Spalten: %5)</translation>
    </message>
    <message>
        <source>may be a rate or a time; write its unit, as 1/s, after the name</source>
        <translation>kann eine Rate oder eine Zeit sein; ihre Einheit, etwa 1/s, hinter den Namen schreiben</translation>
    </message>
    <message>
        <source>has no unit, and %1 is in %2; say with --modulus-unit which unit both have</source>
        <translation>hat keine Einheit, und %1 ist in %2; mit --modulus-unit sagen, welche Einheit beide haben</translation>
    </message>
    <message>
        <source>%1 is %2, which must be above 0; leave the row out or correct it</source>
        <translation>%1 ist %2 und muss über 0 sein; die Zeile weglassen oder berichtigen</translation>
    </message>
    <message>
        <source>the frequency</source>
        <translation>die Frequenz</translation>
    </message>
    <message>
        <source>the storage modulus</source>
        <translation>der Speichermodul</translation>
    </message>
    <message>
        <source>the loss modulus</source>
        <translation>der Verlustmodul</translation>
    </message>
    <message>
        <source>the temperature in K</source>
        <translation>die Temperatur in K</translation>
    </message>
    <message>
        <source>is %1 K in the file's shift; leave %2 out</source>
        <translation>ist %1 K in der Verschiebung der Datei; %2 weglassen</translation>
    </message>
    <message>
        <source>is stated nowhere; say at which the series holds with --temperature, such as --temperature 20C</source>
        <translation>steht nirgends; mit --temperature sagen, bei welcher die Reihe gilt, etwa --temperature 20C</translation>
    </message>
    <message>
        <source>no isotherm is within 1 K of %1</source>
        <translation>keine Isotherme liegt innerhalb von 1 K um %1</translation>
    </message>
    <message>
        <source>leaves no isotherm</source>
        <translation>lässt keine Isotherme übrig</translation>
    </message>
    <message>
        <source>%1 needs more isotherms than %2</source>
        <translation>%1 braucht mehr Isothermen als %2</translation>
    </message>
    <message>
        <source>has %1 rows; allowed is %2, more than an instrument needs</source>
        <translation>hat %1 Zeilen; erlaubt sind %2, mehr als ein Gerät braucht</translation>
    </message>
    <message>
        <source>%1: %2, G∞ = %3, at %4</source>
        <translation>%1: %2, G∞ = %3, bei %4</translation>
    </message>
    <message>
        <source>which frequencies were measured is not known: friction on it is not marked as extrapolated</source>
        <translation>welche Frequenzen gemessen wurden, ist nicht bekannt: Reibung darauf wird nicht als extrapoliert gekennzeichnet</translation>
    </message>
    <message>
        <source>measured: one isotherm at %1, %2 to %3</source>
        <translation>gemessen: eine Isotherme bei %1, %2 bis %3</translation>
    </message>
    <message>
        <source>measured: %1 isotherms from %2 to %3; at %4 they cover %5 to %6</source>
        <translation>gemessen: %1 Isothermen von %2 bis %3; bei %4 decken sie %5 bis %6 ab</translation>
    </message>
    <message>
        <source>rows without a value, left out: %1</source>
        <translation>Zeilen ohne Wert, weggelassen: %1</translation>
    </message>
    <message>
        <source>states a temperature of %1 K, at which no rubber is measured; correct it, or state that of the test with --temperature</source>
        <translation>nennt eine Temperatur von %1 K, bei der kein Gummi gemessen wird; berichtigen, oder die der Prüfung mit --temperature angeben</translation>
    </message>
    <message>
        <source>is %1 by the name of the file and %2 in line %3; say with --temperature which is that of the test</source>
        <translation>ist %1 nach dem Namen der Datei und %2 in Zeile %3; --temperature sagt, welche die der Prüfung ist</translation>
    </message>
    <message>
        <source>is %1 in line %2 and %3 in line %4; say with --temperature which is that of the test</source>
        <translation>ist %1 in Zeile %2 und %3 in Zeile %4; --temperature sagt, welche die der Prüfung ist</translation>
    </message>
    <message>
        <source>the temperature is %1 K, at which no rubber is measured; correct it, or say with --temperature-unit in which unit it is</source>
        <translation>die Temperatur ist %1 K, bei der kein Gummi gemessen wird; berichtigen, oder mit --temperature-unit sagen, in welcher Einheit sie steht</translation>
    </message>
    <message>
        <source>has the unit %1, which is not one of %2</source>
        <translation>hat die Einheit %1, die keine von %2 ist</translation>
    </message>
    <message>
        <source>%1, assumed</source>
        <translation>%1, angenommen</translation>
    </message>
    <message>
        <source>%1 has no unit, as others have; write it after the number</source>
        <translation>%1 hat keine Einheit, anders als andere; sie gehört hinter die Zahl</translation>
    </message>
    <message>
        <source>%1 has the unit %2, which is not understood</source>
        <translation>%1 hat die Einheit %2, die nicht verstanden wird</translation>
    </message>
    <message>
        <source>the mark in the number of %1 may separate decimals or thousands; write thousands without a mark</source>
        <translation>das Zeichen in der Zahl von %1 kann Dezimalen oder Tausender trennen; Tausender sind ohne Trennzeichen zu schreiben</translation>
    </message>
    <message>
        <source>the commas in the list may separate decimals or numbers; write &quot;; &quot; or &quot;, &quot; between the numbers</source>
        <translation>die Kommas der Liste können Dezimalen oder Zahlen trennen; zwischen die Zahlen gehört &quot;; &quot; oder &quot;, &quot;</translation>
    </message>
    <message>
        <source>has no number in any row; correct the column, or take it out</source>
        <translation>hat in keiner Zeile eine Zahl; die Spalte ist zu berichtigen oder wegzulassen</translation>
    </message>
    <message>
        <source>is stated twice, with the shear moduli %1 and %2; leave one of them out</source>
        <translation>steht zweimal da, mit den Schubmoduln %1 und %2; eine der Angaben ist wegzulassen</translation>
    </message>
    <message>
        <source>%1 belongs to no arm; write the number of its arm after the name, or leave it out</source>
        <translation>%1 gehört zu keinem Arm; hinter den Namen gehört die Nummer des Arms, oder die Angabe ist wegzulassen</translation>
    </message>
    <message>
        <source>%1 has no number that can be read; write it as &quot;%2 = 1&quot;, with its unit, or leave it out</source>
        <translation>%1 hat keine lesbare Zahl; zu schreiben ist „%2 = 1“ mit Einheit, oder die Angabe ist wegzulassen</translation>
    </message>
    <message>
        <source>%1 is stated without %2; each arm needs both</source>
        <translation>%1 steht ohne %2 da; jeder Arm braucht beides</translation>
    </message>
    <message>
        <source>%1 is stated in line %2 already</source>
        <translation>%1 steht schon in Zeile %2</translation>
    </message>
    <message>
        <source>%1 matrices, each below the name of its modulus, are read as one table</source>
        <translation>%1 Matrizen, jede unter dem Namen ihres Moduls, werden als eine Tabelle gelesen</translation>
    </message>
    <message>
        <source>the numbers above the columns are taken for temperatures: %1 to %2</source>
        <translation>die Zahlen über den Spalten werden für Temperaturen gehalten: %1 bis %2</translation>
    </message>
    <message>
        <source>has no unit, and its median is %1, more than that of a rubber; write its unit after the name, as in &quot;tan delta (%)&quot; or &quot;tan delta (1)&quot;</source>
        <translation>hat keine Einheit, und der Median ist %1, mehr als der eines Gummis; die Einheit gehört hinter den Namen, wie in „tan delta (%)“ oder „tan delta (1)“</translation>
    </message>
    <message>
        <source>matrices side by side have the names of their moduli above them</source>
        <translation>Matrizen nebeneinander haben die Namen ihrer Moduln über sich</translation>
    </message>
    <message>
        <source>%1 has no unit: seconds are assumed</source>
        <translation>%1 hat keine Einheit: Sekunden werden angenommen</translation>
    </message>
    <message>
        <source>the file does not say of which kind its moduli are: shear is assumed; --modulus tension says otherwise</source>
        <translation>die Datei sagt nicht, von welcher Art ihre Moduln sind: Schub wird angenommen; --modulus tension sagt etwas anderes</translation>
    </message>
    <message>
        <source>moduli of shear, not divided</source>
        <translation>Schubmoduln, nicht geteilt</translation>
    </message>
    <message>
        <source>%1 contradicts the moduli: in the median it is %2 times the ratio of %3 and %4; the moduli are read</source>
        <translation>%1 widerspricht den Moduln: im Median ist es das %2-fache des Verhältnisses von %3 und %4; die Moduln werden gelesen</translation>
    </message>
    <message>
        <source>the table also has moduli of tension, %1 times those of shear in the median (%2 with this Poisson's ratio); those of shear are read, and --modulus tension reads the others</source>
        <translation>die Tabelle hat auch Zugmoduln, im Median das %1-fache der Schubmoduln (%2 bei dieser Querkontraktionszahl); die Schubmoduln werden gelesen, und --modulus tension liest die anderen</translation>
    </message>
    <message>
        <source>the table also has moduli of shear; those of tension are %1 times as large in the median (%2 with this Poisson's ratio) and are read, and --modulus shear reads the others</source>
        <translation>die Tabelle hat auch Schubmoduln; die Zugmoduln sind im Median das %1-fache davon (%2 bei dieser Querkontraktionszahl) und werden gelesen, und --modulus shear liest die anderen</translation>
    </message>
    <message>
        <source>%1 in %2 (assumed)</source>
        <translation>%1 in %2 (angenommen)</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>frequency: %1</source>
        <translation>Frequenz: %1</translation>
    </message>
    <message>
        <source>reduced frequency: %1</source>
        <translation>reduzierte Frequenz: %1</translation>
    </message>
    <message>
        <source>temperature: %1 (line %2: %3)</source>
        <translation>Temperatur: %1 (Zeile %2: %3)</translation>
    </message>
    <message>
        <source>temperature: %1 (name of the file)</source>
        <translation>Temperatur: %1 (Name der Datei)</translation>
    </message>
    <message>
        <source>temperature: %1</source>
        <translation>Temperatur: %1</translation>
    </message>
    <message>
        <source>moduli of tension: %1, %2</source>
        <translation>Zugmoduln: %1, %2</translation>
    </message>
    <message>
        <source>moduli of shear: %1, %2</source>
        <translation>Schubmoduln: %1, %2</translation>
    </message>
    <message>
        <source>these are the columns of the last of %1 sweeps</source>
        <translation>dies sind die Spalten der letzten von %1 Messreihen</translation>
    </message>
    <message>
        <source>the shift that the file states is not read: the isotherms have their own</source>
        <translation>die Verschiebung, die die Datei nennt, wird nicht gelesen: die Isothermen haben ihre eigene</translation>
    </message>
    <message>
        <source>the shift factors from line %1 on are not read: they are no rising table</source>
        <translation>die Verschiebungsfaktoren ab Zeile %1 werden nicht gelesen: sie sind keine steigende Tabelle</translation>
    </message>
    <message>
        <source>the shift factors from line %1 on are not read: they are not those of %2, where log aT would be 0</source>
        <translation>die Verschiebungsfaktoren ab Zeile %1 werden nicht gelesen: sie sind nicht die von %2, wo log aT 0 wäre</translation>
    </message>
    <message>
        <source>shift factors from line %1 on: %2 from %3 to %4</source>
        <translation>Verschiebungsfaktoren ab Zeile %1: %2 von %3 bis %4</translation>
    </message>
    <message>
        <source>C1 is %1 and C2 is %2 K; allowed is C1 above 0 to %3, C2 from %4 to %5 K</source>
        <translation>C1 ist %1 und C2 ist %2 K; zulässig ist C1 über 0 bis %3, C2 von %4 bis %5 K</translation>
    </message>
    <message>
        <source>the constants C1 and C2 are not read: they hold above %1</source>
        <translation>die Konstanten C1 und C2 werden nicht gelesen: sie gelten oberhalb von %1</translation>
    </message>
    <message>
        <source>the constants C1 and C2 are not read: line %1 is about ln aT, and C1 is expected to be that of log10 aT, which is C1 / 2.303</source>
        <translation>die Konstanten C1 und C2 werden nicht gelesen: Zeile %1 handelt von ln aT, und C1 muss das von log10 aT sein, also C1 / 2.303</translation>
    </message>
    <message>
        <source>the constants C1 and C2 are taken as those at %1, the temperature of the curve: no reference temperature is stated for them</source>
        <translation>die Konstanten C1 und C2 gelten als die bei %1, der Temperatur der Kurve: für sie ist keine Bezugstemperatur angegeben</translation>
    </message>
    <message>
        <source>the shift factors from line %1 on rise with temperature, and those of a rubber fall; check their sign</source>
        <translation>die Verschiebungsfaktoren ab Zeile %1 steigen mit der Temperatur, die eines Gummis fallen; bitte das Vorzeichen prüfen</translation>
    </message>
    <message>
        <source>shift of the file: Williams, Landel and Ferry with C1 = %1, C2 = %2 K at %3</source>
        <translation>Verschiebung der Datei: Williams, Landel und Ferry mit C1 = %1, C2 = %2 K bei %3</translation>
    </message>
    <message>
        <source>the constants C1 and C2 are not read: the file has shift factors</source>
        <translation>die Konstanten C1 und C2 werden nicht gelesen: die Datei hat Verschiebungsfaktoren</translation>
    </message>
    <message>
        <source>line %1 is about a shift and is not read: C1 and C2 with values, an activation energy as Ea = 80 kJ/mol, or a table of temperature and log aT, would be</source>
        <translation>Zeile %1 handelt von einer Verschiebung und wird nicht gelesen: C1 und C2 mit Werten, eine Aktivierungsenergie wie Ea = 80 kJ/mol oder eine Tabelle aus Temperatur und log aT würden gelesen</translation>
    </message>
    <message>
        <source>C2 has the unit %1, which is none of a difference of temperatures, such as K, °C or °F</source>
        <translation>C2 hat die Einheit %1, die keine eines Temperaturunterschieds ist wie K, °C oder °F</translation>
    </message>
    <message>
        <source>the activation energy is %1 J/mol; allowed is above 0 to %2 J/mol</source>
        <translation>die Aktivierungsenergie ist %1 J/mol; erlaubt ist über 0 bis %2 J/mol</translation>
    </message>
    <message>
        <source>shift of the file: Arrhenius with %1 at %2</source>
        <translation>Verschiebung der Datei: Arrhenius mit %1 bei %2</translation>
    </message>
    <message>
        <source>%1 is not what the file states, the constants of %2</source>
        <translation>%1 ist nicht, was die Datei nennt, die Konstanten von %2</translation>
    </message>
    <message>
        <source>the isotherms at %1 and %2 do not overlap: only a vertical shift, as of an entropic spring, brings their moduli together; allow it with --vertical-shifts</source>
        <translation>die Isothermen bei %1 und %2 überlappen nicht: nur eine vertikale Verschiebung wie die einer entropischen Feder bringt ihre Moduln zusammen; --vertical-shifts lässt sie zu</translation>
    </message>
    <message>
        <source>moduli of tension, divided by %1 for shear (Poisson's ratio %2)</source>
        <translation>Zugmoduln, für Schub durch %1 geteilt (Querkontraktionszahl %2)</translation>
    </message>
    <message>
        <source>overlaps: neighbours agree within %1 to %2 decades (rms)</source>
        <translation>Überlappungen: Nachbarn stimmen auf %1 bis %2 Dekaden überein (Effektivwert)</translation>
    </message>
    <message>
        <source>Prony series: %1 from %2 relaxation times, G∞ = %3; rms residual %4 % of G′, %5 % of G″</source>
        <translation>Prony-Reihe: %1 aus %2 Relaxationszeiten, G∞ = %3; Restabweichung %4 % von G′, %5 % von G″ (Effektivwert)</translation>
    </message>
    <message>
        <source>Williams, Landel and Ferry: C1 = %1, C2 = %2 K, %3 decades rms</source>
        <translation>Williams, Landel und Ferry: C1 = %1, C2 = %2 K, %3 Dekaden (Effektivwert)</translation>
    </message>
    <message>
        <source>Arrhenius: %1, %2 decades rms</source>
        <translation>Arrhenius: %1, %2 Dekaden (Effektivwert)</translation>
    </message>
    <message>
        <source>is not stated for each of the sweeps side by side in the columns %1; write it into the names, as in &quot;G' 20C (MPa)&quot;, or once for each sweep into a row above them</source>
        <translation>ist nicht für jede der Messreihen nebeneinander in den Spalten %1 angegeben; in die Namen schreiben, wie in &quot;G' 20C (MPa)&quot;, oder einmal je Messreihe in eine Zeile darüber</translation>
    </message>
    <message>
        <source>has columns of moduli that belong to no sweep with a frequency and both moduli: %1; take them out, or say with --storage-column and --loss-column which are meant</source>
        <translation>hat Spalten von Moduln, die zu keiner Messreihe mit Frequenz und beiden Moduln gehören: %1; sie herausnehmen, oder mit --storage-column und --loss-column sagen, welche gemeint sind</translation>
    </message>
    <message>
        <source>%1 states no strain amplitude</source>
        <translation>%1 gibt keine Dehnungsamplitude an</translation>
    </message>
    <message>
        <source>%1 % was not measured; there is %2</source>
        <translation>%1 % wurde nicht gemessen; vorhanden sind %2</translation>
    </message>
    <message>
        <source>differs between sweeps at one temperature, and so do the moduli (Payne effect); choose one amplitude with --strain: %1</source>
        <translation>ist in Messreihen bei derselben Temperatur verschieden, und damit auch die Moduln (Payne-Effekt); eine Amplitude mit --strain wählen: %1</translation>
    </message>
    <message>
        <source>'%1' is not a strain such as 1%</source>
        <translation>„%1“ ist keine Dehnung wie 1%</translation>
    </message>
    <message>
        <source>repeated at the same temperature and frequency: %1 rows, averaged; moduli that became one differ by a factor of up to %2</source>
        <translation>bei derselben Temperatur und Frequenz wiederholt: %1 Zeilen, gemittelt; zusammengefasste Moduln unterscheiden sich bis zum Faktor %2</translation>
    </message>
    <message>
        <source>%1 at %2 and %3 is %4, where the points beside it suggest %5</source>
        <translation>%1 bei %2 und %3 ist %4, wo die Punkte daneben %5 erwarten lassen</translation>
    </message>
    <message>
        <source>the isotherms at %1 and %2 overlap only without a point that leaves its curve: %3; correct its row, or take it out</source>
        <translation>die Isothermen bei %1 und %2 überlappen nur ohne einen Punkt, der von seiner Kurve abweicht: %3; seine Zeile berichtigen oder herausnehmen</translation>
    </message>
    <message>
        <source>more points leave the curve of their neighbours: %1</source>
        <translation>weitere Punkte weichen von der Kurve ihrer Nachbarn ab: %1</translation>
    </message>
    <message>
        <source>%1; without it a shift changes by %2 decades: correct its row, or take it out</source>
        <translation>%1; ohne ihn ändert sich eine Verschiebung um %2 Dekaden: seine Zeile berichtigen oder herausnehmen</translation>
    </message>
    <message>
        <source>%1: correct its row, or take it out</source>
        <translation>%1: seine Zeile berichtigen oder herausnehmen</translation>
    </message>
    <message>
        <source>vertical shifts of up to %1 % between neighbours, as of an entropic spring or an uncertain size of the sample, lower what neighbours differ by from %2 to %3 % (rms); without them shifts are uncertain by up to %4 decades: --vertical-shifts</source>
        <translation>senkrechte Verschiebungen von bis zu %1 % zwischen Nachbarn, wie bei einer entropischen Feder oder ungenauer Probengröße, senken die Abweichung der Nachbarn von %2 auf %3 % (Effektivwert); ohne sie sind Verschiebungen um bis zu %4 Dekaden unsicher: --vertical-shifts</translation>
    </message>
    <message>
        <source>not thermorheologically simple: beyond their noise, neighbours differ by %1 % (rms) where they overlap, which no shift explains; predictions at other temperatures are approximate</source>
        <translation>nicht thermorheologisch einfach: über ihr Rauschen hinaus weichen Nachbarn, wo sie überlappen, um %1 % (Effektivwert) voneinander ab, was keine Verschiebung erklärt; Vorhersagen bei anderen Temperaturen sind Näherungen</translation>
    </message>
    <message>
        <source>in %1 of %2 overlaps the moduli do not tell a vertical shift from a horizontal one, as power laws of one exponent do not: there the law of entropy elasticity, b_T ~ T, decides</source>
        <translation>bei %1 von %2 Überlappungen unterscheiden die Moduln eine vertikale Verschiebung nicht von einer horizontalen, wie bei Potenzgesetzen mit einem Exponenten: dort entscheidet das Gesetz der Entropieelastizität, b_T ~ T</translation>
    </message>
    <message>
        <source>in %1 of %2 overlaps the moduli do not tell a vertical shift from a horizontal one, as power laws of one exponent do not: there the shifts hold for b_T = 1</source>
        <translation>bei %1 von %2 Überlappungen unterscheiden die Moduln eine vertikale Verschiebung nicht von einer horizontalen, wie bei Potenzgesetzen mit einem Exponenten: dort gelten die Verschiebungen für b_T = 1</translation>
    </message>
    <message>
        <source>holds a test over time: relaxation tests, G(t), and creep tests, J(t), are not read; what is read are G′ and G″ over frequency at one or several temperatures, and Prony series</source>
        <translation>enthält einen Versuch über der Zeit: Relaxationsversuche, G(t), und Kriechversuche, J(t), werden nicht gelesen; gelesen werden G′ und G″ über der Frequenz bei einer oder mehreren Temperaturen und Prony-Reihen</translation>
    </message>
    <message>
        <source>a table of temperatures and log aT below the numbers in the file, or a line with C1 and C2 above them, would be read as the shift</source>
        <translation>eine Tabelle von Temperaturen und log aT unter den Zahlen der Datei oder eine Zeile mit C1 und C2 darüber würde als Verschiebung gelesen</translation>
    </message>
    <message>
        <source>there is no such file; the nearest shipped scene is %1</source>
        <translation>es gibt keine solche Datei; am ähnlichsten ist die mitgelieferte Szene %1</translation>
    </message>
    <message>
        <source>Measured friction holds local friction, the curves of other settings do not: with mu_total as the vertical axis, all do.</source>
        <translation>Gemessene Reibung enthält lokale Reibung, die Kurven anderer Einstellungen nicht: mit mu_total als senkrechter Achse enthalten sie alle.</translation>
    </message>
    <message>
        <source>without waves shorter than %1 friction of deformation is half as large</source>
        <translation>ohne Wellen kürzer als %1 ist die Reibung der Verformung halb so groß</translation>
    </message>
    <message>
        <source>at the shortest waves of the line, one decade of wavelengths makes %1 % of friction: shorter waves, which the line does not have, would change it</source>
        <translation>bei den kürzesten Wellen der Linie macht eine Dekade der Wellenlängen %1 % der Reibung aus: kürzere Wellen, welche die Linie nicht hat, würden sie ändern</translation>
    </message>
    <message>
        <source>one temperature alone: there is no shift, and scenes need elastomer.temperature=%1</source>
        <translation>nur eine Temperatur: es gibt keine Verschiebung, und Szenen brauchen elastomer.temperature=%1</translation>
    </message>
    <message>
        <source>one arm</source>
        <translation>ein Arm</translation>
    </message>
    <message>
        <source>%1 arms</source>
        <translation>%1 Arme</translation>
    </message>
    <message>
        <source>material %1 is read: of the %2 materials in the file, it has the series</source>
        <translation>Material %1 wird gelesen: von den %2 Materialien der Datei hat es die Reihe</translation>
    </message>
    <message>
        <source>has several values in the file, %1; choose one with --temperature</source>
        <translation>hat mehrere Werte in der Datei, %1; einen mit --temperature wählen</translation>
    </message>
    <message>
        <source>has values at %1 and none within %2 K of the reference of the shift, %3; --temperature-tolerance allows more, or give --equilibrium-modulus</source>
        <translation>hat Werte bei %1 und keinen innerhalb von %2 K um den Bezug der Verschiebung, %3; --temperature-tolerance erlaubt mehr, oder --equilibrium-modulus angeben</translation>
    </message>
    <message>
        <source>has values at %1 and none within %2 K of %3; choose one of these with --temperature, or allow more with --temperature-tolerance</source>
        <translation>hat Werte bei %1 und keinen innerhalb von %2 K um %3; eine dieser Temperaturen mit --temperature wählen, oder mit --temperature-tolerance mehr erlauben</translation>
    </message>
    <message>
        <source>has more than one row at %1; keep the one that is meant alone</source>
        <translation>hat mehr als eine Zeile bei %1; nur die gemeinte stehen lassen</translation>
    </message>
    <message>
        <source>the values at %1 are read, with the temperatures of the file in %2; --temperature-unit says another</source>
        <translation>die Werte bei %1 werden gelesen, mit den Temperaturen der Datei in %2; --temperature-unit sagt eine andere Einheit</translation>
    </message>
    <message>
        <source>the values at %1 are read</source>
        <translation>die Werte bei %1 werden gelesen</translation>
    </message>
    <message>
        <source>a single row at temperature 0 is read as one for every temperature: programs write 0 where none was chosen</source>
        <translation>eine einzige Zeile bei der Temperatur 0 wird als eine für jede Temperatur gelesen: Programme schreiben 0, wo keine gewählt wurde</translation>
    </message>
    <message>
        <source>has moduli that depend on field variables, which are not read; give --equilibrium-modulus</source>
        <translation>hat Moduln, die von Feldvariablen abhängen und nicht gelesen werden; --equilibrium-modulus angeben</translation>
    </message>
    <message>
        <source>has moduli that differ with direction, which are not read; give --equilibrium-modulus</source>
        <translation>hat Moduln, die von der Richtung abhängen und nicht gelesen werden; --equilibrium-modulus angeben</translation>
    </message>
    <message>
        <source>is a second modulus of the same material; keep the one that is meant</source>
        <translation>ist ein zweiter Modul desselben Materials; nur den gemeinten stehen lassen</translation>
    </message>
    <message>
        <source>has no modulus</source>
        <translation>hat keinen Modul</translation>
    </message>
    <message>
        <source>is a second TB,PRONY; keep the material that is meant alone</source>
        <translation>ist ein zweites TB,PRONY; nur das gemeinte Material stehen lassen</translation>
    </message>
    <message>
        <source>is a second TBTEMP of the same temperature; keep the one that is meant</source>
        <translation>ist ein zweites TBTEMP derselben Temperatur; nur das gemeinte stehen lassen</translation>
    </message>
    <message>
        <source>changes with temperature as a polynomial, which is not read; write MPTEMP and MPDATA, or give --instantaneous-modulus</source>
        <translation>ändert sich mit der Temperatur als Polynom, das nicht gelesen wird; MPTEMP und MPDATA schreiben, oder --instantaneous-modulus angeben</translation>
    </message>
    <message>
        <source>has a value in place %1 for which MPTEMP has no temperature</source>
        <translation>hat einen Wert an der Stelle %1, für die MPTEMP keine Temperatur hat</translation>
    </message>
    <message>
        <source>begins at a place that is outside 1 to %1</source>
        <translation>beginnt an einer Stelle außerhalb von 1 bis %1</translation>
    </message>
    <message>
        <source>states a property of the same material again; keep the one that is meant</source>
        <translation>nennt eine Eigenschaft desselben Materials noch einmal; nur die gemeinte stehen lassen</translation>
    </message>
    <message>
        <source>has no constant %1</source>
        <translation>hat keine Konstante %1</translation>
    </message>
    <message>
        <source>has a hyperelastic form whose shear modulus is not read; NEO, MOONEY and YEOH are, or give --instantaneous-modulus</source>
        <translation>hat eine hyperelastische Form, deren Schubmodul nicht gelesen wird; NEO, MOONEY und YEOH werden es, oder --instantaneous-modulus angeben</translation>
    </message>
    <message>
        <source>has a shift for more than one temperature; keep the one that is meant</source>
        <translation>hat eine Verschiebung für mehr als eine Temperatur; nur die gemeinte stehen lassen</translation>
    </message>
    <message>
        <source>the reference temperature %1 of the file is taken in %2; --temperature-unit says another</source>
        <translation>die Bezugstemperatur %1 der Datei gilt in %2; --temperature-unit sagt eine andere Einheit</translation>
    </message>
    <message>
        <source>the shift with temperature by %1 is left out; one of Williams, Landel and Ferry (WLF) is read</source>
        <translation>die Verschiebung mit der Temperatur nach %1 wird weggelassen; gelesen wird eine von Williams, Landel und Ferry (WLF)</translation>
    </message>
    <message>
        <source>%1 is %2, outside %3 to %4</source>
        <translation>%1 ist %2, außerhalb von %3 bis %4</translation>
    </message>
    <message>
        <source>looks like the moduli of a Prony series, but there is no column of relaxation times; such a table has columns as tau (s) and G (MPa), or g_i for parts of the instantaneous modulus</source>
        <translation>sieht aus wie die Moduln einer Prony-Reihe, aber es gibt keine Spalte von Relaxationszeiten; eine solche Tabelle hat Spalten wie tau (s) und G (MPa), oder g_i für Teile des Anfangsmoduls</translation>
    </message>
    <message>
        <source>may be 1/tau or 1/(2 pi tau); write the arms&apos; relaxation times, as tau (s), or their rates 1/tau, as omega_i (rad/s)</source>
        <translation>kann 1/tau oder 1/(2 pi tau) sein; die Relaxationszeiten der Arme angeben, als tau (s), oder ihre Raten 1/tau, als omega_i (rad/s)</translation>
    </message>
    <message>
        <source>has %1 rows, each of which is a Prony series by the names of its columns; keep the one that is meant</source>
        <translation>hat %1 Zeilen, von denen nach den Namen der Spalten jede eine Prony-Reihe ist; die gemeinte behalten</translation>
    </message>
    <message>
        <source>looks like the relaxation times of a Prony series, but there is no column of moduli; such a table has columns as tau (s) and G (MPa), or g_i for parts of the instantaneous modulus</source>
        <translation>sieht aus wie die Relaxationszeiten einer Prony-Reihe, aber es gibt keine Spalte von Moduln; eine solche Tabelle hat Spalten wie tau (s) und G (MPa), oder g_i für Teile des Anfangsmoduls</translation>
    </message>
    <message>
        <source>is a keyword of %1 that is not read; those of Abaqus, Ansys and LS-DYNA (*MAT_GENERAL_VISCOELASTIC, *MAT_VISCOELASTIC) are, or write the Prony series as a table with columns tau (s) and G (MPa), whose tau is 1/beta, and the equilibrium modulus in a row with tau = inf</source>
        <translation>ist ein Schlüsselwort von %1, das nicht gelesen wird; gelesen werden die von Abaqus, Ansys und LS-DYNA (*MAT_GENERAL_VISCOELASTIC, *MAT_VISCOELASTIC); oder die Prony-Reihe als Tabelle mit den Spalten tau (s) und G (MPa) schreiben, deren tau 1/beta ist, mit dem Gleichgewichtsmodul in einer Zeile mit tau = inf</translation>
    </message>
    <message>
        <source>keywords of LS-DYNA</source>
        <translation>Schlüsselwörter von LS-DYNA</translation>
    </message>
    <message>
        <source>is a keyword of LS-DYNA without numbers</source>
        <translation>ist ein Schlüsselwort von LS-DYNA ohne Zahlen</translation>
    </message>
    <message>
        <source>is a keyword of LS-DYNA without a pair of GI and BETAI</source>
        <translation>ist ein Schlüsselwort von LS-DYNA ohne ein Paar aus GI und BETAI</translation>
    </message>
    <message>
        <source>has fields that are neither 10 characters wide nor separated by commas</source>
        <translation>hat Felder, die weder 10 Zeichen breit noch durch Kommas getrennt sind</translation>
    </message>
    <message>
        <source>has %1 in place %2, where a number of at least 0 is read</source>
        <translation>hat %1 an Stelle %2, wo eine Zahl von mindestens 0 gelesen wird</translation>
    </message>
    <message>
        <source>does not tell its units: a density of %1 and a modulus of %2 are those of a rubber in no or in several systems of units; write the Prony series as a table with columns such as tau (s) and G (MPa), whose tau is 1/beta, and the equilibrium modulus in a row with tau = inf</source>
        <translation>verrät seine Einheiten nicht: eine Dichte von %1 und ein Modul von %2 sind in keinem oder in mehreren Einheitensystemen die eines Gummis; die Prony-Reihe als Tabelle mit Spalten wie tau (s) und G (MPa) schreiben, mit tau gleich 1/beta und dem Gleichgewichtsmodul in einer Zeile mit tau = inf</translation>
    </message>
    <message>
        <source>is of an elastic layer (EF), without a series</source>
        <translation>ist von einer elastischen Schicht (EF), ohne Reihe</translation>
    </message>
    <message>
        <source>takes its constants from a curve (LCID), which is not read</source>
        <translation>nimmt seine Konstanten aus einer Kurve (LCID), die nicht gelesen wird</translation>
    </message>
    <message>
        <source>the shift with temperature by TREF, A and B is left out, because the sign and the base of the logarithm that A belongs to are not certain; the series holds at TREF</source>
        <translation>die Verschiebung mit der Temperatur durch TREF, A und B bleibt weg, weil Vorzeichen und Basis des Logarithmus, zu dem A gehört, nicht sicher sind; die Reihe gilt bei TREF</translation>
    </message>
    <message>
        <source>does not relax: G0 must be above GI, and BETA above 0</source>
        <translation>relaxiert nicht: G0 muss über GI liegen und BETA über 0</translation>
    </message>
    <message>
        <source>is a second viscoelastic material; keep the one that is meant alone</source>
        <translation>ist ein zweites viskoelastisches Material; nur das gemeinte stehen lassen</translation>
    </message>
    <message>
        <source>is written in the long format, which is not read</source>
        <translation>ist im langen Format geschrieben, das nicht gelesen wird</translation>
    </message>
    <message>
        <source>the file states no units; a density of %1 is that of a rubber in %2, so moduli are read in %3 and times in %4</source>
        <translation>die Datei nennt keine Einheiten; eine Dichte von %1 ist die eines Gummis in %2, also werden Moduln in %3 und Zeiten in %4 gelesen</translation>
    </message>
    <message>
        <source>is a second row without a relaxation time; one, of the equilibrium modulus, is allowed</source>
        <translation>ist eine zweite Zeile ohne Relaxationszeit; eine, die des Gleichgewichtsmoduls, ist erlaubt</translation>
    </message>
    <message>
        <source>are parts that add up to %1 with that of the row without a relaxation time, and not to 1</source>
        <translation>sind Teile, die mit dem der Zeile ohne Relaxationszeit zusammen %1 ergeben und nicht 1</translation>
    </message>
    <message>
        <source>has a viscosity and no relaxation time</source>
        <translation>hat eine Viskosität und keine Relaxationszeit</translation>
    </message>
    <message>
        <source>has no unit; write it after the name, as in eta_i (Pa s)</source>
        <translation>hat keine Einheit; sie hinter den Namen schreiben, wie in eta_i (Pa s)</translation>
    </message>
    <message>
        <source>moduli are %1 divided by the relaxation times</source>
        <translation>die Moduln sind %1 geteilt durch die Relaxationszeiten</translation>
    </message>
    <message>
        <source>relaxation times are %1 divided by the moduli</source>
        <translation>die Relaxationszeiten sind %1 geteilt durch die Moduln</translation>
    </message>
    <message>
        <source>%1 contradicts the moduli and relaxation times, which are read: in the median it is %2 times their product</source>
        <translation>%1 widerspricht den Moduln und Relaxationszeiten, die gelesen werden: im Median ist es das %2-Fache ihres Produkts</translation>
    </message>
    <message>
        <source>columns without names are read as branches in a file of COMSOL: number, modulus of shear, relaxation time in s</source>
        <translation>Spalten ohne Namen werden als Zweige in einer Datei von COMSOL gelesen: Nummer, Schubmodul, Relaxationszeit in s</translation>
    </message>
    <message>
        <source>%1 is read as a logarithm to base 10</source>
        <translation>%1 wird als Logarithmus zur Basis 10 gelesen</translation>
    </message>
    <message>
        <source>%1 is above the lowest storage modulus of shear, %2; allowed is a modulus below it</source>
        <translation>%1 liegt über dem kleinsten Speichermodul der Scherung, %2; erlaubt ist ein kleinerer Modul</translation>
    </message>
    <message>
        <source>one temperature alone: there is no shift</source>
        <translation>nur eine Temperatur: es gibt keine Verschiebung</translation>
    </message>
    <message>
        <source>the shift is that of Williams, Landel and Ferry</source>
        <translation>die Verschiebung ist die von Williams, Landel und Ferry</translation>
    </message>
    <message>
        <source>the shift is that of Arrhenius</source>
        <translation>die Verschiebung ist die von Arrhenius</translation>
    </message>
    <message>
        <source>not thermorheologically simple: shifts from G′ alone and from G″ alone differ by up to %1 decades between neighbours, %2 in all; predictions at other temperatures are approximate</source>
        <translation>nicht thermorheologisch einfach: Verschiebungen aus G′ allein und aus G″ allein unterscheiden sich um bis zu %1 Dekaden zwischen Nachbarn, %2 insgesamt; Vorhersagen bei anderen Temperaturen sind Näherungen</translation>
    </message>
    <message>
        <source>there is no file of this name, and %1</source>
        <translation>es gibt keine Datei dieses Namens, und %1</translation>
    </message>
    <message>
        <source>has no rows</source>
        <translation>hat keine Zeilen</translation>
    </message>
    <message>
        <source>%1 K is outside the shift table, %2 to %3 K</source>
        <translation>%1 K liegt außerhalb der Verschiebungstabelle, %2 bis %3 K</translation>
    </message>
    <message>
        <source>row %1 of the measured friction: %2</source>
        <translation>Zeile %1 der gemessenen Reibung: %2</translation>
    </message>
    <message>
        <source>has %1 rows; allowed is %2</source>
        <translation>hat %1 Zeilen; erlaubt ist %2</translation>
    </message>
    <message>
        <source>needs an object of temperature and log10_shift</source>
        <translation>braucht ein Objekt aus temperature und log10_shift</translation>
    </message>
    <message>
        <source>unknown key; a row has temperature and log10_shift</source>
        <translation>unbekannter Schlüssel; eine Zeile hat temperature und log10_shift</translation>
    </message>
    <message>
        <source>%1 K is not above the %2 K of the row before; the rows are needed in the order of rising temperature</source>
        <translation>%1 K liegt nicht über den %2 K der Zeile davor; die Zeilen müssen nach steigender Temperatur geordnet sein</translation>
    </message>
    <message>
        <source>a list of 1 to %1 {temperature, log10_shift}, %2 and %3</source>
        <translation>eine Liste von 1 bis %1 {temperature, log10_shift}, %2 und %3</translation>
    </message>
    <message>
        <source>a material is JSON in UTF-8, which 'asperity material' makes from a table of measured moduli</source>
        <translation>ein Material ist JSON in UTF-8, das 'asperity material' aus einer Tabelle gemessener Moduln macht</translation>
    </message>
    <message>
        <source>is not %1</source>
        <translation>ist nicht %1</translation>
    </message>
    <message>
        <source>unknown key of a material</source>
        <translation>unbekannter Schlüssel eines Materials</translation>
    </message>
    <message>
        <source>at %1</source>
        <translation>bei %1</translation>
    </message>
    <message>
        <source>frequency f</source>
        <translation>Frequenz f</translation>
    </message>
    <message>
        <source>frequency f %1</source>
        <translation>Frequenz f %1</translation>
    </message>
    <message>
        <source>reduced frequency f aᴛ %1</source>
        <translation>Frequenz f aᴛ %1</translation>
    </message>
    <message>
        <source>%1: isotherms</source>
        <translation>%1: Isothermen</translation>
    </message>
    <message>
        <source>storage modulus G′</source>
        <translation>Speichermodul G′</translation>
    </message>
    <message>
        <source>loss modulus G″</source>
        <translation>Verlustmodul G″</translation>
    </message>
    <message>
        <source>log</source>
        <translation>logarithmisch</translation>
    </message>
    <message>
        <source>evaluation</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>least χ² so far</source>
        <translation>kleinstes χ² bisher</translation>
    </message>
    <message>
        <source>a fit</source>
        <translation>eine Anpassung</translation>
    </message>
    <message>
        <source>moduli G′, G″</source>
        <translation>Moduln G′, G″</translation>
    </message>
    <message>
        <source>'%1' is not a unit of temperature</source>
        <translation>„%1“ ist keine Einheit der Temperatur</translation>
    </message>
    <message>
        <source>the unit '%1' is not a unit of strain; known are %, ppm, mm/mm</source>
        <translation>die Einheit „%1“ ist keine Einheit einer Dehnung; bekannt sind %, ppm, mm/mm</translation>
    </message>
    <message>
        <source>has %1 rows; allowed is 1 to %2</source>
        <translation>hat %1 Zeilen; erlaubt sind 1 bis %2</translation>
    </message>
    <message>
        <source>%1 is %2; allowed is %3 to %4</source>
        <translation>%1 ist %2; erlaubt ist %3 bis %4</translation>
    </message>
    <message>
        <source>has %1 K twice</source>
        <translation>hat %1 K zweimal</translation>
    </message>
    <message>
        <source>needs two columns: temperature and log10 of the shift</source>
        <translation>braucht zwei Spalten: Temperatur und log10 der Verschiebung</translation>
    </message>
    <message>
        <source>holds a shift factor that is not above 0</source>
        <translation>enthält einen Verschiebungsfaktor, der nicht über 0 ist</translation>
    </message>
    <message>
        <source>modulus G′, G″</source>
        <translation>Modul G′, G″</translation>
    </message>
    <message>
        <source>residual</source>
        <translation>Restabweichung</translation>
    </message>
    <message>
        <source>%1: master curve</source>
        <translation>%1: Masterkurve</translation>
    </message>
    <message>
        <source>%1, G∞ = %2, rms residual %3 % of G′ and %4 % of G″</source>
        <translation>%1, G∞ = %2, Restabweichung %3 % von G′ und %4 % von G″ (Effektivwert)</translation>
    </message>
    <message>
        <source>Not thermorheologically simple: shifts of the frequency alone do not bring the points of all temperatures onto one curve.</source>
        <translation>Nicht thermorheologisch einfach: Verschiebungen der Frequenz allein bringen die Punkte aller Temperaturen nicht auf eine Kurve.</translation>
    </message>
    <message>
        <source>%1: loss tangent</source>
        <translation>%1: Verlustfaktor</translation>
    </message>
    <message>
        <source>loss tangent tan δ</source>
        <translation>Verlustfaktor tan δ</translation>
    </message>
    <message>
        <source>Prony series</source>
        <translation>Prony-Reihe</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>%1: shifts with temperature</source>
        <translation>%1: Verschiebungen mit der Temperatur</translation>
    </message>
    <message>
        <source>temperature T</source>
        <translation>Temperatur T</translation>
    </message>
    <message>
        <source>shift log₁₀ aᴛ</source>
        <translation>Verschiebung log₁₀ aᴛ</translation>
    </message>
    <message>
        <source>from both moduli</source>
        <translation>aus beiden Moduln</translation>
    </message>
    <message>
        <source>from G′ alone</source>
        <translation>aus G′ allein</translation>
    </message>
    <message>
        <source>from G″ alone</source>
        <translation>aus G″ allein</translation>
    </message>
    <message>
        <source>WLF, %1 decades rms</source>
        <translation>WLF, %1 Dekaden (Effektivwert)</translation>
    </message>
    <message>
        <source>Arrhenius, %1 decades rms</source>
        <translation>Arrhenius, %1 Dekaden (Effektivwert)</translation>
    </message>
    <message>
        <source>excited at %1</source>
        <translation>angeregt bei %1</translation>
    </message>
    <message>
        <source>tan δ</source>
        <translation>tan δ</translation>
    </message>
    <message>
        <source>loss per decade / largest</source>
        <translation>Verlust je Dekade, relativ</translation>
    </message>
    <message>
        <source>nothing is dissipated at this velocity</source>
        <translation>bei dieser Geschwindigkeit wird nichts dissipiert</translation>
    </message>
    <message>
        <source>Where the rubber is used at %1</source>
        <translation>Wo das Gummi bei %1 gebraucht wird</translation>
    </message>
    <message>
        <source>the line excites no loss at this velocity</source>
        <translation>die Linie regt bei dieser Geschwindigkeit keinen Verlust an</translation>
    </message>
    <message>
        <source>at %1 the line excites %2 to %3, half of the loss below %4</source>
        <translation>bei %1 regt die Linie Frequenzen von %2 bis %3 an; die Hälfte des Verlusts liegt unter %4</translation>
    </message>
    <message>
        <source>%1; measured were %2 to %3, %4 % of the loss is extrapolated</source>
        <translation>%1; gemessen wurden %2 bis %3, %4 % des Verlusts sind extrapoliert</translation>
    </message>
    <message>
        <source>beyond the measured frequencies</source>
        <translation>jenseits der gemessenen Frequenzen</translation>
    </message>
    <message>
        <source>Beyond the measured frequencies: more than a tenth of the loss rests on frequencies at which the rubber was not measured.</source>
        <translation>Jenseits der gemessenen Frequenzen: mehr als ein Zehntel des Verlusts beruht auf Frequenzen, bei denen das Gummi nicht gemessen wurde.</translation>
    </message>
    <message>
        <source>another shift table</source>
        <translation>eine andere Verschiebungstabelle</translation>
    </message>
    <message>
        <source>material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>A shipped material or a material file, relative to the scene; it gives moduli, relaxation times and shift, and a key beside it replaces that one value.</source>
        <translation>Ein mitgeliefertes Material oder eine Materialdatei, relativ zur Szene; sie gibt Moduln, Relaxationszeiten und Verschiebung, und ein Schlüssel daneben ersetzt diesen einen Wert.</translation>
    </message>
    <message>
        <source>shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>How temperature shifts the relaxation times: by Williams, Landel and Ferry (wlf), by an activation energy (arrhenius), or as measured (table).</source>
        <translation>Wie die Temperatur die Relaxationszeiten verschiebt: nach Williams, Landel und Ferry (wlf), mit einer Aktivierungsenergie (arrhenius) oder wie gemessen (table).</translation>
    </message>
    <message>
        <source>activation energy</source>
        <translation>Aktivierungsenergie</translation>
    </message>
    <message>
        <source>Activation energy of the shift with temperature (Arrhenius).</source>
        <translation>Aktivierungsenergie der Verschiebung mit der Temperatur (Arrhenius).</translation>
    </message>
    <message>
        <source>shift table</source>
        <translation>Verschiebungstabelle</translation>
    </message>
    <message>
        <source>Measured shifts: temperature in K and log10 of the factor on all relaxation times, linear in between; there is none outside.</source>
        <translation>Gemessene Verschiebungen: Temperatur in K und log10 des Faktors auf alle Relaxationszeiten, dazwischen linear; außerhalb gibt es keine.</translation>
    </message>
    <message>
        <source>lowest measured frequency</source>
        <translation>tiefste gemessene Frequenz</translation>
    </message>
    <message>
        <source>Lowest frequency at which the elastomer was measured, at the temperature of no shift; friction that rests on others is marked. 0: not known.</source>
        <translation>Tiefste Frequenz, bei der das Elastomer gemessen wurde, bei der Temperatur ohne Verschiebung; Reibung, die auf anderen beruht, wird gekennzeichnet. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>highest measured frequency</source>
        <translation>höchste gemessene Frequenz</translation>
    </message>
    <message>
        <source>Highest frequency at which the elastomer was measured, at the temperature of no shift. 0: not known.</source>
        <translation>Höchste Frequenz, bei der das Elastomer gemessen wurde, bei der Temperatur ohne Verschiebung. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>lowest measured temperature</source>
        <translation>tiefste gemessene Temperatur</translation>
    </message>
    <message>
        <source>Lowest temperature at which the elastomer was measured. 0: not known.</source>
        <translation>Tiefste Temperatur, bei der das Elastomer gemessen wurde. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>highest measured temperature</source>
        <translation>höchste gemessene Temperatur</translation>
    </message>
    <message>
        <source>Highest temperature at which the elastomer was measured. 0: not known.</source>
        <translation>Höchste Temperatur, bei der das Elastomer gemessen wurde. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>measured strain</source>
        <translation>Messdehnung</translation>
    </message>
    <message>
        <source>Amplitude of the strain with which the elastomer was measured. 0: not known.</source>
        <translation>Amplitude der Verformung, mit der das Elastomer gemessen wurde. 0: nicht bekannt.</translation>
    </message>
    <message>
        <source>leaves a period of %1 points; at least %2 are needed</source>
        <translation>lässt eine Periode von %1 Punkten; mindestens %2 sind nötig</translation>
    </message>
    <message>
        <source>of a surface</source>
        <translation>einer Fläche</translation>
    </message>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>smd</source>
        <translation>SMD</translation>
    </message>
    <message>
        <source>zygo</source>
        <translation>Zygo</translation>
    </message>
    <message>
        <source>wyko</source>
        <translation>Wyko</translation>
    </message>
    <message>
        <source>surfer</source>
        <translation>Surfer</translation>
    </message>
    <message>
        <source>npy</source>
        <translation>NumPy</translation>
    </message>
    <message>
        <source>x3p</source>
        <translation>X3P</translation>
    </message>
    <message>
        <source>valleys</source>
        <translation>Täler</translation>
    </message>
    <message>
        <source>unstated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>um</source>
        <translation>µm</translation>
    </message>
    <message>
        <source>sur</source>
        <translation>SUR</translation>
    </message>
    <message>
        <source>summits</source>
        <translation>Gipfel</translation>
    </message>
    <message>
        <source>interpolate</source>
        <translation>interpolieren</translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation>Spektrum</translation>
    </message>
    <message>
        <source>sdf</source>
        <translation>SDF</translation>
    </message>
    <message>
        <source>refuse</source>
        <translation>ablehnen</translation>
    </message>
    <message>
        <source>random-phases</source>
        <translation>Zufallsphasen</translation>
    </message>
    <message>
        <source>pressure</source>
        <translation>Druck</translation>
    </message>
    <message>
        <source>periodic</source>
        <translation>periodisch</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>nm</source>
        <translation>nm</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>spiegeln</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>matrix</source>
        <translation>Matrix</translation>
    </message>
    <message>
        <source>isotropic-equivalent</source>
        <translation>isotrop gleichwertig</translation>
    </message>
    <message>
        <source>in</source>
        <translation>in</translation>
    </message>
    <message>
        <source>gwyddion</source>
        <translation>Gwyddion</translation>
    </message>
    <message>
        <source>gsf</source>
        <translation>GSF</translation>
    </message>
    <message>
        <source>gwy</source>
        <translation>GWY</translation>
    </message>
    <message>
        <source>auto</source>
        <translation>automatisch</translation>
    </message>
    <message>
        <source>along-x</source>
        <translation>längs x</translation>
    </message>
    <message>
        <source>along-y</source>
        <translation>längs y</translation>
    </message>
    <message>
        <source>c1-two-sided</source>
        <translation>C1 zweiseitig</translation>
    </message>
    <message>
        <source>c1-one-sided</source>
        <translation>C1 einseitig</translation>
    </message>
    <message>
        <source>blend</source>
        <translation>überblenden</translation>
    </message>
    <message>
        <source>wlf</source>
        <translation>WLF</translation>
    </message>
    <message>
        <source>arrhenius</source>
        <translation>Arrhenius</translation>
    </message>
    <message>
        <source>table</source>
        <translation>Tabelle</translation>
    </message>
    <message>
        <source>as-measured</source>
        <translation>wie gemessen</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>needs two columns: modulus in Pa and relaxation time in s</source>
        <translation>braucht zwei Spalten: Modul in Pa und Relaxationszeit in s</translation>
    </message>
    <message>
        <source>needs a column of relaxation times and one of moduli, named such as tau and G</source>
        <translation>braucht eine Spalte von Relaxationszeiten und eine von Moduln, mit Namen wie tau und G</translation>
    </message>
    <message>
        <source>holds a modulus or a time that is not above 0, or too large</source>
        <translation>enthält einen Modul oder eine Zeit, die nicht über 0 liegt oder zu groß ist</translation>
    </message>
    <message>
        <source>there is not enough memory for this surface</source>
        <translation>für diese Oberfläche reicht der Speicher nicht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not one of %2</source>
        <translation>„%1“ ist nichts von %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has no unit; write °C, K or °F after it</source>
        <translation>„%1“ hat keine Einheit; dahinter steht °C, K oder °F</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a temperature such as 20 °C, 293.15 K or 68 °F</source>
        <translation>„%1“ ist keine Temperatur wie 20 °C, 293,15 K oder 68 °F</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a temperature such as 20C, 293.15K or 68F</source>
        <translation>„%1“ ist keine Temperatur wie 20C, 293.15K oder 68F</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not a modulus such as 2.3MPa</source>
        <translation>„%1“ ist kein Modul wie 2.3MPa</translation>
    </message>
    <message>
        <source>Rubber A (unnamed)</source>
        <translation>Gummi A (ohne Namen)</translation>
    </message>
    <message>
        <source>%1 Hz is outside %2 to %3 Hz</source>
        <translation>%1 Hz liegt außerhalb von %2 bis %3 Hz</translation>
    </message>
    <message>
        <source>standard error of μ</source>
        <translation>Standardfehler von μ</translation>
    </message>
    <message>
        <source>friction by Eq. (11)</source>
        <translation>Reibung nach Gl. (11)</translation>
    </message>
    <message>
        <source>contact fraction</source>
        <translation>Kontaktanteil</translation>
    </message>
    <message>
        <source>rms slope in contact</source>
        <translation>RMS-Steigung im Kontakt</translation>
    </message>
    <message>
        <source>friction over rms slope</source>
        <translation>Reibung durch RMS-Steigung</translation>
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
        <source>friction, deformation and local</source>
        <translation>Reibung durch Verformung und lokale Reibung</translation>
    </message>
    <message>
        <source>mean of the ratios of forces</source>
        <translation>Mittel der Kraftverhältnisse</translation>
    </message>
    <message>
        <source>ratio of the mean forces</source>
        <translation>Verhältnis der mittleren Kräfte</translation>
    </message>
    <message>
        <source>share of the marginal element</source>
        <translation>Anteil des Randelements</translation>
    </message>
    <message>
        <source>nominal pressure p₀</source>
        <translation>nomineller Druck p₀</translation>
    </message>
    <message>
        <source>mean pressure in contact</source>
        <translation>mittlerer Druck im Kontakt</translation>
    </message>
    <message>
        <source>exponent d ln μ / d ln x</source>
        <translation>Exponent d ln μ / d ln x</translation>
    </message>
    <message>
        <source>exponent d ln μ / d ln (parameter)</source>
        <translation>Exponent d ln μ / d ln (Parameter)</translation>
    </message>
    <message>
        <source>share of friction per decade</source>
        <translation>Anteil der Reibung je Dekade</translation>
    </message>
    <message>
        <source>Friction over %1 and %2</source>
        <translation>Karte der Reibung: %1 und %2</translation>
    </message>
    <message>
        <source>Map over %1 and %2: %3</source>
        <translation>Karte (%1 und %2): %3</translation>
    </message>
    <message>
        <source>Dashed: borders of the regions I to IV, each read from the friction curve at one value of the other parameter.</source>
        <translation>Gestrichelt: Grenzen der Bereiche I bis IV, jeweils aus der Reibungskurve bei einem Wert des anderen Parameters abgelesen.</translation>
    </message>
    <message>
        <source>Dashed: Fₙ/(4ηv) = 0.1 h (η: viscosity); beyond it few contacts carry the load (region IV).</source>
        <translation>Gestrichelt: Fₙ/(4ηv) = 0,1 h (η: Viskosität); jenseits davon tragen wenige Kontakte die Last (Bereich IV).</translation>
    </message>
    <message>
        <source>Cross: the scene's own state.</source>
        <translation>Kreuz: der Zustand der Szene selbst.</translation>
    </message>
    <message>
        <source>Friction does not depend on the %1 here.</source>
        <translation>Die Reibung hängt hier nicht ab von: %1.</translation>
    </message>
    <message>
        <source>This quantity does not apply to these states.</source>
        <translation>Diese Größe hat für diese Zustände keine Bedeutung.</translation>
    </message>
    <message>
        <source>says how friction is computed or shown, and cannot be a side of a map</source>
        <translation>sagt, wie Reibung berechnet oder gezeigt wird, und kann keine Seite einer Karte sein</translation>
    </message>
    <message>
        <source>a map has 2 to %1 points along each side, not %2</source>
        <translation>eine Karte hat 2 bis %1 Punkte entlang jeder Seite, nicht %2</translation>
    </message>
    <message>
        <source>%1 to %2 is only one value; a side of a map needs two</source>
        <translation>%1 bis %2 ist nur ein Wert; eine Seite einer Karte braucht zwei</translation>
    </message>
    <message>
        <source>is both sides of the map; they need two different keys</source>
        <translation>ist auf beiden Seiten der Karte; sie brauchen zwei verschiedene Schlüssel</translation>
    </message>
    <message>
        <source>%1 times %2 points are more than %3 cells</source>
        <translation>%1 mal %2 Punkte sind mehr als %3 Zellen</translation>
    </message>
    <message>
        <source>a map has the same lines in every cell</source>
        <translation>eine Karte hat in jeder Zelle dieselben Linien</translation>
    </message>
    <message>
        <source>all cut-offs have the same lines</source>
        <translation>alle Grenzwellenlängen haben dieselben Linien</translation>
    </message>
    <message>
        <source>differences need the same lines on both sides</source>
        <translation>Differenzen brauchen auf beiden Seiten dieselben Linien</translation>
    </message>
    <message>
        <source>a fit needs the same lines everywhere</source>
        <translation>eine Anpassung braucht überall dieselben Linien</translation>
    </message>
    <message>
        <source>%1; give accuracy.scheme and ensemble.realizations instead of a target</source>
        <translation>%1; statt eines Ziels accuracy.scheme und ensemble.realizations angeben</translation>
    </message>
    <message>
        <source>has no short waves to remove; a random line, a profile, a spectrum or a measured surface has</source>
        <translation>hat keine kurzen Wellen, die man entfernen könnte; eine Zufallslinie, ein Profil, ein Spektrum oder eine gemessene Oberfläche hat sie</translation>
    </message>
    <message>
        <source>short-wave cut-off λ</source>
        <translation>kurze Grenzwellenlänge λ</translation>
    </message>
    <message>
        <source>Friction against the short-wave cut-off</source>
        <translation>Reibung über der kurzen Grenzwellenlänge</translation>
    </message>
    <message>
        <source>Friction of the same lines without their waves shorter than λ, and the share of it that the waves of one decade of wavelengths make.</source>
        <translation>Reibung derselben Linien ohne ihre Wellen kürzer als λ, und der Anteil daran, den die Wellen einer Dekade der Wellenlängen machen.</translation>
    </message>
    <message>
        <source>What friction depends on</source>
        <translation>Wovon die Reibung abhängt</translation>
    </message>
    <message>
        <source>Friction changes with no parameter here.</source>
        <translation>Die Reibung ändert sich hier mit keinem Parameter.</translation>
    </message>
    <message>
        <source>At %1 m/s: by how many per cent friction changes where a parameter changes by one per cent. Lines: one standard error, with an arrow where it goes on. Pale: smaller than its error.</source>
        <translation>Bei %1 m/s: um wie viel Prozent sich die Reibung ändert, wo sich ein Parameter um ein Prozent ändert. Linien: ein Standardfehler, mit einem Pfeil, wo er weitergeht. Blass: kleiner als der eigene Fehler.</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>axis from</source>
        <translation>Achse von</translation>
    </message>
    <message>
        <source>axis to</source>
        <translation>Achse bis</translation>
    </message>
    <message>
        <source>axis scale</source>
        <translation>Achsenteilung</translation>
    </message>
    <message>
        <source>The key on the horizontal axis of the friction curve: any number that changes friction in the scene.</source>
        <translation>Der Schlüssel auf der waagrechten Achse der Reibungskurve: jede Zahl, die in der Szene die Reibung ändert.</translation>
    </message>
    <message>
        <source>First value of another key than velocity, in its unit; from above to runs downwards.</source>
        <translation>Erster Wert eines anderen Schlüssels als der Geschwindigkeit, in dessen Einheit; liegt er über dem letzten, geht es abwärts.</translation>
    </message>
    <message>
        <source>Last value of another key than velocity, in its unit.</source>
        <translation>Letzter Wert eines anderen Schlüssels als der Geschwindigkeit, in dessen Einheit.</translation>
    </message>
    <message>
        <source>Points of the friction curve; of whole numbers, values that repeat are left out.</source>
        <translation>Punkte der Reibungskurve; bei ganzen Zahlen entfallen Werte, die sich wiederholen.</translation>
    </message>
    <message>
        <source>How the points of the friction curve are spaced: evenly in their logarithm (log), or evenly (linear).</source>
        <translation>Wie die Punkte der Reibungskurve verteilt sind: logarithmisch gleich (log) oder gleich (linear).</translation>
    </message>
    <message>
        <source>has no meaning for %1 %2; it belongs to all others</source>
        <translation>hat keine Bedeutung für %1 %2; gehört zu allen anderen</translation>
    </message>
    <message>
        <source>is missing; %1 %2 needs it</source>
        <translation>fehlt; %1 %2 braucht es</translation>
    </message>
    <message>
        <source>%1 has no meaning in this scene</source>
        <translation>%1 hat in dieser Szene keine Bedeutung</translation>
    </message>
    <message>
        <source>%1 has no meaning for %2 %3</source>
        <translation>%1 hat keine Bedeutung für %2 %3</translation>
    </message>
    <message>
        <source>%1 is outside %2 of %3</source>
        <translation>%1 liegt außerhalb von %2 von %3</translation>
    </message>
    <message>
        <source>%1 has no place on a logarithmic axis; sweep.scale linear has room for it</source>
        <translation>%1 hat auf einer logarithmischen Achse keinen Platz; bei sweep.scale linear hat es einen</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>%1 says how the curve is made, which cannot be its axis</source>
        <translation>%1 sagt, wie die Kurve entsteht, und kann nicht ihre Achse sein</translation>
    </message>
    <message>
        <source>%1 says how the file is read, which cannot be an axis</source>
        <translation>%1 sagt, wie die Datei gelesen wird, und kann keine Achse sein</translation>
    </message>
    <message>
        <source>%1 changes nothing in this scene</source>
        <translation>%1 ändert in dieser Szene nichts</translation>
    </message>
    <message>
        <source>%1 values of %2, those on the same lines side by side</source>
        <translation>%1 Werte von %2, die auf denselben Linien nebeneinander</translation>
    </message>
    <message>
        <source>only one value of %1 is asked for</source>
        <translation>nur ein Wert von %1 ist gefragt</translation>
    </message>
    <message>
        <source>%1 goes over velocities, not over %2</source>
        <translation>%1 geht über Geschwindigkeiten, nicht über %2</translation>
    </message>
    <message>
        <source>is 0: a curve over %1 slides at it, so it needs more</source>
        <translation>ist 0: eine Kurve über %1 gleitet mit ihr, also braucht sie mehr</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>tangential force</source>
        <translation>Tangentialkraft</translation>
    </message>
    <message>
        <source>power</source>
        <translation>Leistung</translation>
    </message>
    <message>
        <source>Friction over %1</source>
        <translation>Reibung über: %1</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 über: %2</translation>
    </message>
    <message>
        <source>nothing to show on these axes</source>
        <translation>auf diesen Achsen ist nichts zu zeigen</translation>
    </message>
    <message>
        <source>%1 is not shown: it has no column of %2</source>
        <translation>%1 ist nicht gezeigt: Es hat keine Spalte für %2</translation>
    </message>
    <message>
        <source>%1 is not shown: it was measured at another velocity, load or temperature than the scene&apos;s</source>
        <translation>%1 ist nicht gezeigt: Gemessen wurde bei anderer Geschwindigkeit, Last oder Temperatur als der der Szene</translation>
    </message>
    <message>
        <source>%1: %2 of %3 points; the others were measured at another velocity, load or temperature</source>
        <translation>%1: %2 von %3 Punkten; die anderen wurden bei anderer Geschwindigkeit, Last oder Temperatur gemessen</translation>
    </message>
    <message>
        <source>%1.</source>
        <translation>%1.</translation>
    </message>
    <message>
        <source>all curves of a chart go over the same key</source>
        <translation>alle Kurven eines Diagramms gehen über denselben Schlüssel</translation>
    </message>
    <message>
        <source>%1 is the axis of the curves already</source>
        <translation>%1 ist schon die Achse der Kurven</translation>
    </message>
    <message>
        <source>%1 curves are more than %2</source>
        <translation>%1 Kurven sind mehr als %2</translation>
    </message>
    <message>
        <source>dimensionless goes over velocities, not over %1</source>
        <translation>dimensionless geht über Geschwindigkeiten, nicht über %1</translation>
    </message>
    <message>
        <source>belongs to physical axes; dimensionless ones show mu over the slope</source>
        <translation>gehört zu physikalischen Achsen; dimensionslose zeigen mu über der Steigung</translation>
    </message>
    <message>
        <source>contacts in a period</source>
        <translation>Kontakte in einer Periode</translation>
    </message>
    <message>
        <source>%1 of %2 chunks are missing (simulations %3)%4</source>
        <translation>%1 von %2 Blöcken fehlen (Simulationen %3)%4</translation>
    </message>
    <message>
        <source>; no store is of shard %1</source>
        <translation>; kein Speicher ist von Teil %1</translation>
    </message>
    <message>
        <source>%1: %2 of %3 simulations are not there yet</source>
        <translation>%1: %2 von %3 Simulationen sind noch nicht da</translation>
    </message>
    <message>
        <source>needs an object</source>
        <translation>verlangt ein Objekt</translation>
    </message>
    <message>
        <source>needs a number</source>
        <translation>verlangt eine Zahl</translation>
    </message>
    <message>
        <source>is missing; it needs a number</source>
        <translation>fehlt; verlangt ist eine Zahl</translation>
    </message>
    <message>
        <source>%1 is not a whole number from %2 to %3</source>
        <translation>%1 ist keine ganze Zahl von %2 bis %3</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>verlangt einen Text</translation>
    </message>
    <message>
        <source>unknown key; known are %1</source>
        <translation>unbekannter Schlüssel; bekannt sind %1</translation>
    </message>
    <message>
        <source>has no influence on one simulation, so it cannot be varied</source>
        <translation>hat auf eine einzelne Simulation keinen Einfluss und kann deshalb nicht variiert werden</translation>
    </message>
    <message>
        <source>a study slides steadily; it cannot be varied</source>
        <translation>in einer Studie gleitet die Linie stationär; das kann nicht variiert werden</translation>
    </message>
    <message>
        <source>a study needs a stated accuracy, not a target</source>
        <translation>eine Studie verlangt eine angegebene Genauigkeit, kein Ziel</translation>
    </message>
    <message>
        <source>is not a number, so it has no range; a list names its values</source>
        <translation>ist keine Zahl und hat deshalb keinen Bereich; eine Liste nennt die Werte</translation>
    </message>
    <message>
        <source>is neither log nor linear</source>
        <translation>ist weder log noch linear</translation>
    </message>
    <message>
        <source>has no meaning in a sample; it belongs to sampling grid</source>
        <translation>hat in einer Stichprobe keine Bedeutung; es gehört zu sampling grid</translation>
    </message>
    <message>
        <source>is not above from</source>
        <translation>liegt nicht über from</translation>
    </message>
    <message>
        <source>is missing; a grid needs the number of values</source>
        <translation>fehlt; ein Gitter braucht die Zahl der Werte</translation>
    </message>
    <message>
        <source>is not a number, so it has no distribution</source>
        <translation>ist keine Zahl und hat deshalb keine Verteilung</translation>
    </message>
    <message>
        <source>a distribution needs sampling latin_hypercube, sobol or saltelli, not a grid</source>
        <translation>eine Verteilung verlangt sampling latin_hypercube, sobol oder saltelli, kein Gitter</translation>
    </message>
    <message>
        <source>a uniform distribution has either from and to, or mean and deviation</source>
        <translation>eine Gleichverteilung hat entweder from und to oder mean und deviation</translation>
    </message>
    <message>
        <source>is not above 0</source>
        <translation>liegt nicht über 0</translation>
    </message>
    <message>
        <source>of a lognormal distribution is not above 0</source>
        <translation>einer Lognormalverteilung liegt nicht über 0</translation>
    </message>
    <message>
        <source>almost nothing of the distribution is between from and to</source>
        <translation>zwischen from und to liegt fast nichts von der Verteilung</translation>
    </message>
    <message>
        <source>has two columns of %1</source>
        <translation>hat zwei Spalten für %1</translation>
    </message>
    <message>
        <source>needs the lists keys and values, or the name of a table</source>
        <translation>verlangt die Listen keys und values oder den Namen einer Tabelle</translation>
    </message>
    <message>
        <source>needs texts</source>
        <translation>verlangt Texte</translation>
    </message>
    <message>
        <source>needs lists of as many values as there are keys</source>
        <translation>verlangt Listen mit so vielen Werten, wie es Schlüssel gibt</translation>
    </message>
    <message>
        <source>column '%1' is not a scene key</source>
        <translation>Spalte „%1“ ist kein Schlüssel einer Szene</translation>
    </message>
    <message>
        <source>column '%1' is not a scene key; the nearest known one is %2</source>
        <translation>Spalte „%1“ ist kein Schlüssel einer Szene; der nächste bekannte ist %2</translation>
    </message>
    <message>
        <source>column %1 is in %2; a study takes plain numbers in %3</source>
        <translation>Spalte %1 ist in %2; eine Studie nimmt bloße Zahlen in %3</translation>
    </message>
    <message>
        <source>line %1: %2 is missing</source>
        <translation>Zeile %1: %2 fehlt</translation>
    </message>
    <message>
        <source>line %1: %2: %3</source>
        <translation>Zeile %1: %2: %3</translation>
    </message>
    <message>
        <source>needs the name of a table with a column for each key</source>
        <translation>verlangt den Namen einer Tabelle mit einer Spalte für jeden Schlüssel</translation>
    </message>
    <message>
        <source>has no row</source>
        <translation>hat keine Zeile</translation>
    </message>
    <message>
        <source>has %1 rows; at most %2 are allowed</source>
        <translation>hat %1 Zeilen; höchstens %2 sind erlaubt</translation>
    </message>
    <message>
        <source>has %1 values; at most %2 are allowed</source>
        <translation>hat %1 Werte; höchstens %2 sind erlaubt</translation>
    </message>
    <message>
        <source>has no value</source>
        <translation>hat keinen Wert</translation>
    </message>
    <message>
        <source>needs a list of values, a range {"from", "to", "points", "scale"} or a distribution</source>
        <translation>verlangt eine Liste von Werten, einen Bereich {"from", "to", "points", "scale"} oder eine Verteilung</translation>
    </message>
    <message>
        <source>needs a list of names</source>
        <translation>verlangt eine Liste von Namen</translation>
    </message>
    <message>
        <source>'%1' is unknown; the nearest known one is %2</source>
        <translation>„%1“ ist unbekannt; der nächste bekannte Name ist %2</translation>
    </message>
    <message>
        <source>needs an object of keys and what they are varied over</source>
        <translation>verlangt ein Objekt von Schlüsseln mit dem, worüber sie variieren</translation>
    </message>
    <message>
        <source>is varied twice</source>
        <translation>wird zweimal variiert</translation>
    </message>
    <message>
        <source>is in set and in space; one of them is enough</source>
        <translation>steht in set und in space; eines von beiden genügt</translation>
    </message>
    <message>
        <source>has %1 keys; with this sampling at most %2 are allowed</source>
        <translation>hat %1 Schlüssel; bei dieser Stichprobe sind höchstens %2 erlaubt</translation>
    </message>
    <message>
        <source>has no meaning for sampling grid; it belongs to all others</source>
        <translation>hat für sampling grid keine Bedeutung; es gehört zu allen anderen</translation>
    </message>
    <message>
        <source>is missing; only sampling grid does without</source>
        <translation>fehlt; nur sampling grid kommt ohne aus</translation>
    </message>
    <message>
        <source>plans more than %1 simulations</source>
        <translation>plant mehr als %1 Simulationen</translation>
    </message>
    <message>
        <source>is what the curve goes over, so it cannot be varied as well</source>
        <translation>ist das, worüber die Kurve geht, und kann nicht zugleich variiert werden</translation>
    </message>
    <message>
        <source>is not above 0, where friction is wanted</source>
        <translation>liegt nicht über 0, obwohl Reibung verlangt ist</translation>
    </message>
    <message>
        <source>%1 is new</source>
        <translation>%1 ist neu</translation>
    </message>
    <message>
        <source>%1 is %2 instead of %3</source>
        <translation>%1 ist %2 statt %3</translation>
    </message>
    <message>
        <source>%1 is missing</source>
        <translation>%1 fehlt</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source>%1 over each parameter</source>
        <translation>%1 über jedem Parameter</translation>
    </message>
    <message>
        <source>%1 with its scatter</source>
        <translation>%1 mit ihrer Streuung</translation>
    </message>
    <message>
        <source>Which parameter is responsible for the scatter</source>
        <translation>Welcher Parameter für die Streuung verantwortlich ist</translation>
    </message>
    <message>
        <source>First order: the share of the variance that goes where the parameter is known. Total: the share that stays where all others are known. Bars: 95 % confidence.</source>
        <translation>Erste Ordnung: der Anteil der Varianz, der wegfällt, wenn der Parameter bekannt ist. Gesamt: der Anteil, der bleibt, wenn alle anderen bekannt sind. Balken: 95 % Vertrauen.</translation>
    </message>
    <message>
        <source>first order</source>
        <translation>erste Ordnung</translation>
    </message>
    <message>
        <source>total</source>
        <translation>gesamt</translation>
    </message>
    <message>
        <source>parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>share of the variance</source>
        <translation>Anteil an der Varianz</translation>
    </message>
    <message>
        <source>correlation</source>
        <translation>Korrelation</translation>
    </message>
    <message>
        <source>median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>rows</source>
        <translation>Zeilen</translation>
    </message>
    <message>
        <source>5 % to 95 %</source>
        <translation>5 % bis 95 %</translation>
    </message>
    <message>
        <source>25 % to 75 %</source>
        <translation>25 % bis 75 %</translation>
    </message>
    <message>
        <source>Correlation of the results with the parameters</source>
        <translation>Korrelation der Ergebnisse mit den Parametern</translation>
    </message>
    <message>
        <source>Correlation of the values (of the logarithm where a key is varied over it) and of their ranks; 1 and −1 mean that the parameter decides alone.</source>
        <translation>Korrelation der Werte (des Logarithmus, wo ein Schlüssel über ihn variiert wird) und ihrer Ränge; 1 und −1 heißen, dass der Parameter allein entscheidet.</translation>
    </message>
    <message>
        <source>of the values</source>
        <translation>der Werte</translation>
    </message>
    <message>
        <source>of the ranks</source>
        <translation>der Ränge</translation>
    </message>
    <message>
        <source>Points: single simulations. Line: mean over all other parameters, with its standard error.</source>
        <translation>Punkte: einzelne Simulationen. Linie: Mittel über alle anderen Parameter mit seinem Standardfehler.</translation>
    </message>
    <message>
        <source>single simulations</source>
        <translation>einzelne Simulationen</translation>
    </message>
    <message>
        <source>Bands: from the 5th to the 95th, and from the 25th to the 75th percentile.</source>
        <translation>Bänder: vom 5. zum 95. und vom 25. zum 75. Perzentil.</translation>
    </message>
    <message>
        <source>the whole study</source>
        <translation>der ganzen Studie</translation>
    </message>
    <message>
        <source>shard %1/%2</source>
        <translation>Teil %1/%2</translation>
    </message>
    <message>
        <source>'%1' is not I/N, such as 3/8</source>
        <translation>„%1“ ist nicht I/N, etwa 3/8</translation>
    </message>
    <message>
        <source>%1 is outside 1/N to N/N, with N from 1 to %2</source>
        <translation>%1 liegt außerhalb von 1/N bis N/N mit N von 1 bis %2</translation>
    </message>
    <message>
        <source>is the store of another study: %1; another store is needed</source>
        <translation>ist der Speicher einer anderen Studie: %1; ein anderer Speicher ist nötig</translation>
    </message>
    <message>
        <source>the store is of %1, not of %2</source>
        <translation>der Speicher ist von %1, nicht von %2</translation>
    </message>
    <message>
        <source>is not there</source>
        <translation>ist nicht da</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is empty; 'asperity study run' fills it</source>
        <translation>ist leer; 'asperity study run' füllt ihn</translation>
    </message>
    <message>
        <source>is not the store of a study</source>
        <translation>ist nicht der Speicher einer Studie</translation>
    </message>
    <message>
        <source>is not the store of a study, but %1</source>
        <translation>ist nicht der Speicher einer Studie, sondern %1</translation>
    </message>
    <message>
        <source>is damaged (%1); the study has to be run into another store, or merged from intact ones</source>
        <translation>ist beschädigt (%1); die Studie muss in einen anderen Speicher gerechnet oder aus heilen zusammengefügt werden</translation>
    </message>
    <message>
        <source>is damaged: chunk %1 is not what was written; the study has to be run into another store, or merged from intact ones</source>
        <translation>ist beschädigt: Block %1 ist nicht, was geschrieben wurde; die Studie muss in einen anderen Speicher gerechnet oder aus heilen zusammengefügt werden</translation>
    </message>
    <message>
        <source>cannot be written, the disk is full; what is done stays, and the same command goes on when there is room</source>
        <translation>kann nicht geschrieben werden, die Platte ist voll; was fertig ist, bleibt, und derselbe Befehl macht weiter, wenn Platz ist</translation>
    </message>
    <message>
        <source>is in use by another process; a shard belongs to one process at a time</source>
        <translation>wird von einem anderen Prozess benutzt; ein Teil gehört jeweils einem Prozess</translation>
    </message>
    <message>
        <source>cannot be written: %1; what is done stays, and the same command goes on afterwards</source>
        <translation>kann nicht geschrieben werden: %1; was fertig ist, bleibt, und derselbe Befehl macht danach weiter</translation>
    </message>
    <message>
        <source>cannot be locked: %1</source>
        <translation>kann nicht gesperrt werden: %1</translation>
    </message>
    <message>
        <source>is a database, but not the store of a study</source>
        <translation>ist eine Datenbank, aber nicht der Speicher einer Studie</translation>
    </message>
    <message>
        <source>has schema %1; this program knows %2: a newer one is needed</source>
        <translation>hat Schema %1; dieses Programm kennt %2: ein neueres ist nötig</translation>
    </message>
    <message>
        <source>is damaged: its study cannot be read</source>
        <translation>ist beschädigt: seine Studie kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>has other results of chunk %1 than the stores before it</source>
        <translation>hat andere Ergebnisse von Block %1 als die Speicher davor</translation>
    </message>
    <message>
        <source>there is no store to merge</source>
        <translation>es gibt keinen Speicher zum Zusammenfügen</translation>
    </message>
    <message>
        <source>is of another study than %1: %2</source>
        <translation>ist von einer anderen Studie als %1: %2</translation>
    </message>
    <message>
        <source>needs a text, or a list of paragraphs</source>
        <translation>braucht einen Text oder eine Liste von Absätzen</translation>
    </message>
    <message>
        <source>is missing; it needs a text</source>
        <translation>fehlt; es braucht einen Text</translation>
    </message>
    <message>
        <source>needs a value; allowed is %1</source>
        <translation>braucht einen Wert; erlaubt ist %1</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is unknown; known are %2</source>
        <translation>„%1“ ist unbekannt; bekannt sind %2</translation>
    </message>
    <message>
        <source>needs the name of a column</source>
        <translation>braucht den Namen einer Spalte</translation>
    </message>
    <message>
        <source>needs one of quantity, peak, exponent</source>
        <translation>braucht quantity, peak oder exponent</translation>
    </message>
    <message>
        <source>is missing; an exponent needs key, from and to</source>
        <translation>fehlt; ein Exponent braucht key, from und to</translation>
    </message>
    <message>
        <source>has no meaning here; it belongs to an exponent</source>
        <translation>hat hier keine Bedeutung; es gehört zu einem Exponenten</translation>
    </message>
    <message>
        <source>needs two different values above 0 in from and to</source>
        <translation>braucht in from und to zwei verschiedene Werte über 0</translation>
    </message>
    <message>
        <source>stands only in the outer value</source>
        <translation>steht nur im äußeren Wert</translation>
    </message>
    <message>
        <source>speaks of a value %1 that the step does not have; known are %2</source>
        <translation>spricht von einem Wert %1, den der Schritt nicht hat; bekannt sind %2</translation>
    </message>
    <message>
        <source>needs two values from 0 on, of which to is the larger one</source>
        <translation>braucht zwei Werte ab 0, von denen to der größere ist</translation>
    </message>
    <message>
        <source>needs two values above 0, of which to is the larger one</source>
        <translation>braucht zwei Werte über 0, von denen to der größere ist</translation>
    </message>
    <message>
        <source>needs a list of at most %1 objects of keys</source>
        <translation>braucht eine Liste von höchstens %1 Objekten mit Schlüsseln</translation>
    </message>
    <message>
        <source>has another axis than the curve beside which it stands</source>
        <translation>hat eine andere Achse als die Kurve, neben der es steht</translation>
    </message>
    <message>
        <source>needs a list of keys</source>
        <translation>braucht eine Liste von Schlüsseln</translation>
    </message>
    <message>
        <source>needs an object of at most %1 values</source>
        <translation>braucht ein Objekt mit höchstens %1 Werten</translation>
    </message>
    <message>
        <source>needs a name of small letters, digits and _, which is not answer or given</source>
        <translation>braucht einen Namen aus kleinen Buchstaben, Ziffern und _, der nicht answer oder given ist</translation>
    </message>
    <message>
        <source>has no meaning here; it belongs to %1</source>
        <translation>hat hier keine Bedeutung; es gehört zu %1</translation>
    </message>
    <message>
        <source>a choice</source>
        <translation>einer Auswahl</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>einer Zahl</translation>
    </message>
    <message>
        <source>a point</source>
        <translation>einem Punkt</translation>
    </message>
    <message>
        <source>a number or a choice</source>
        <translation>einer Zahl oder einer Auswahl</translation>
    </message>
    <message>
        <source>a number or a point</source>
        <translation>einer Zahl oder einem Punkt</translation>
    </message>
    <message>
        <source>a point without x</source>
        <translation>einem Punkt ohne x</translation>
    </message>
    <message>
        <source>is missing; a number is computed</source>
        <translation>fehlt; eine Zahl wird berechnet</translation>
    </message>
    <message>
        <source>above 0 to %1</source>
        <translation>über 0 bis %1</translation>
    </message>
    <message>
        <source>needs a list of %1 to %2 choices</source>
        <translation>braucht eine Liste von %1 bis %2 Antworten</translation>
    </message>
    <message>
        <source>needs true or false</source>
        <translation>braucht true oder false</translation>
    </message>
    <message>
        <source>has above or below, which need a computed answer</source>
        <translation>hat above oder below, die eine berechnete Antwort brauchen</translation>
    </message>
    <message>
        <source>follows from the computed answer; give above or below</source>
        <translation>folgt aus der berechneten Antwort; zu nennen ist above oder below</translation>
    </message>
    <message>
        <source>needs above or below, where the answer is computed</source>
        <translation>braucht above oder below, da die Antwort berechnet wird</translation>
    </message>
    <message>
        <source>needs above to be less than below</source>
        <translation>braucht ein above, das kleiner als below ist</translation>
    </message>
    <message>
        <source>overlaps choices[%1]; one answer would make both right</source>
        <translation>überlappt choices[%1]; ein Ergebnis würde beide richtig machen</translation>
    </message>
    <message>
        <source>has %1 right choices; it needs one, or a computed answer</source>
        <translation>hat %1 richtige Antworten; es braucht eine, oder eine berechnete Antwort</translation>
    </message>
    <message>
        <source>needs show.tab curve, on which the point stands</source>
        <translation>braucht show.tab curve, auf dem der Punkt steht</translation>
    </message>
    <message>
        <source>%1 is outside %2, the axis of the curve</source>
        <translation>%1 liegt außerhalb von %2, der Achse der Kurve</translation>
    </message>
    <message>
        <source>needs a list of 1 to %1 steps</source>
        <translation>braucht eine Liste von 1 bis %1 Schritten</translation>
    </message>
    <message>
        <source>holds the results of a student, not a lesson</source>
        <translation>enthält die Ergebnisse von Lernenden, keine Lektion</translation>
    </message>
    <message>
        <source>is larger than %1 bytes, the most that a lesson may have</source>
        <translation>ist größer als %1 Bytes, mehr darf eine Lektion nicht haben</translation>
    </message>
    <message>
        <source>is neither a file nor a shipped lesson; those are %1</source>
        <translation>ist weder eine Datei noch eine mitgelieferte Lektion; diese sind %1</translation>
    </message>
    <message>
        <source>is missing; the first step needs a scene</source>
        <translation>fehlt; der erste Schritt braucht eine Szene</translation>
    </message>
    <message>
        <source>needs the name of a scene, or a scene</source>
        <translation>braucht den Namen einer Szene oder eine Szene</translation>
    </message>
    <message>
        <source>has no meaning without a prediction</source>
        <translation>hat ohne eine Vorhersage keine Bedeutung</translation>
    </message>
    <message>
        <source>a lesson is one JSON object</source>
        <translation>eine Lektion ist ein JSON-Objekt</translation>
    </message>
    <message>
        <source>a lesson is JSON in UTF-8</source>
        <translation>eine Lektion ist JSON in UTF-8</translation>
    </message>
    <message>
        <source>results of a lesson are JSON in UTF-8</source>
        <translation>Ergebnisse einer Lektion sind JSON in UTF-8</translation>
    </message>
    <message>
        <source>belongs to another lesson, or to another version of it (%1); its answers stay as they are</source>
        <translation>gehört zu einer anderen Lektion oder zu einer anderen Fassung davon (%1); die Antworten darin bleiben, wie sie sind</translation>
    </message>
    <message>
        <source>has no value in this scene</source>
        <translation>hat in dieser Szene keinen Wert</translation>
    </message>
    <message>
        <source>is not above 0, so that it has no exponent</source>
        <translation>ist nicht über 0 und hat darum keinen Exponenten</translation>
    </message>
    <message>
        <source>none of them covers the computed answer, %1</source>
        <translation>keine davon deckt die berechnete Antwort %1 ab</translation>
    </message>
    <message>
        <source>is 0, so that it has no ratio</source>
        <translation>ist 0 und hat darum kein Verhältnis</translation>
    </message>
    <message>
        <source>needs a number or null</source>
        <translation>braucht eine Zahl oder null</translation>
    </message>
    <message>
        <source>needs a lesson; without one the shipped lessons are listed</source>
        <translation>braucht eine Lektion; ohne eine werden die mitgelieferten aufgezählt</translation>
    </message>
    <message>
        <source>applies only to handouts, not to results</source>
        <translation>gehört zu einem Arbeitsblatt, nicht zu Ergebnissen</translation>
    </message>
    <message>
        <source>has no results of a lesson</source>
        <translation>hat keine Ergebnisse einer Lektion</translation>
    </message>
    <message>
        <source>has results of &apos;%1&apos;, but %2 has those of &apos;%3&apos;; a table is of one lesson</source>
        <translation>hat Ergebnisse von „%1“, aber %2 hat solche von „%3“; eine Tabelle gilt für eine Lektion</translation>
    </message>
    <message>
        <source>applies only to handouts; give -o as well</source>
        <translation>gehört zu einem Arbeitsblatt; es braucht auch -o</translation>
    </message>
    <message>
        <source>sets keys of a scene, and this file is a lesson</source>
        <translation>setzt Schlüssel einer Szene, und diese Datei ist eine Lektion</translation>
    </message>
    <message>
        <source>%1: its file %2 cannot be read</source>
        <translation>%1: Die Datei %2 ist nicht lesbar</translation>
    </message>
    <message>
        <source>%1 has no characters that can be measured</source>
        <translation>%1 hat keine Zeichen, die sich messen lassen</translation>
    </message>
    <message>
        <source>%1 is in a collection of fonts (.ttc), of which a picture cannot contain a part</source>
        <translation>%1 steht in einer Sammlung von Schriften (.ttc), von der ein Bild keinen Teil enthalten kann</translation>
    </message>
    <message>
        <source>no font family &apos;%1&apos; is installed; &apos;fc-list : family&apos; lists them</source>
        <translation>Es ist keine Schriftfamilie „%1“ installiert; „fc-list : family“ zählt sie auf</translation>
    </message>
    <message>
        <source>no font family &apos;%1&apos; is installed; did you mean &apos;%2&apos;?</source>
        <translation>Es ist keine Schriftfamilie „%1“ installiert; war „%2“ gemeint?</translation>
    </message>
    <message>
        <source>μ with its sign</source>
        <translation>μ mit Vorzeichen</translation>
    </message>
    <message>
        <source>'%1' is unknown; known are %2, curve.NAME for a whole curve, and fit.NAME for what sums it up</source>
        <translation>„%1“ ist unbekannt; bekannt sind %2, curve.NAME für eine ganze Kurve und fit.NAME für das, was sie zusammenfasst</translation>
    </message>
    <message>
        <source>%1 needs a curve of at least %2 points; sweep.points gives %3</source>
        <translation>%1 braucht eine Kurve aus mindestens %2 Punkten; sweep.points ergibt %3</translation>
    </message>
    <message>
        <source>%1 needs a curve over velocity, not over %2</source>
        <translation>%1 braucht eine Kurve über der Geschwindigkeit, nicht über %2</translation>
    </message>
    <message>
        <source>%1 needs an elastomer of one relaxation time, whose curve has regions I to IV</source>
        <translation>%1 braucht ein Elastomer mit einer einzigen Relaxationszeit, dessen Kurve die Bereiche I bis IV hat</translation>
    </message>
    <message>
        <source>%1 % of the curve</source>
        <translation>%1 % der Kurve</translation>
    </message>
    <message>
        <source>At %1 of the motion the rigid line rests.</source>
        <translation>Bei %1 der Bewegung ruht die starre Linie.</translation>
    </message>
    <message>
        <source>At %1 of the motion the rigid line slides to the right at %2.</source>
        <translation>Bei %1 der Bewegung gleitet die starre Linie mit %2 nach rechts.</translation>
    </message>
    <message>
        <source>At %1 of the motion the rigid line slides to the left at %2.</source>
        <translation>Bei %1 der Bewegung gleitet die starre Linie mit %2 nach links.</translation>
    </message>
    <message>
        <source>The rigid line rests.</source>
        <translation>Die starre Linie ruht.</translation>
    </message>
    <message>
        <source>The rigid line slides to the right at %1.</source>
        <translation>Die starre Linie gleitet mit %1 nach rechts.</translation>
    </message>
    <message>
        <source>The rigid line slides to the left at %1.</source>
        <translation>Die starre Linie gleitet mit %1 nach links.</translation>
    </message>
    <message>
        <source>It presses with %1; its lowest point is %2 below the undeformed surface.</source>
        <translation>Sie drückt mit %1; ihr tiefster Punkt liegt %2 unter der unverformten Oberfläche.</translation>
    </message>
    <message>
        <source>The bodies do not touch.</source>
        <translation>Die Körper berühren sich nicht.</translation>
    </message>
    <message>
        <source>All of the surface is in contact.</source>
        <translation>Die ganze Oberfläche ist in Kontakt.</translation>
    </message>
    <message>
        <source>They touch at one contact of %1, which is %2 % of the period of %3.</source>
        <translation>Sie berühren sich in einem Kontakt von %1, das sind %2 % der Periode von %3.</translation>
    </message>
    <message>
        <source>They touch at %1 contacts, %2 % of the period of %3; the longest contact is %4.</source>
        <translation>Sie berühren sich in %1 Kontakten, auf %2 % der Periode von %3; der längste Kontakt misst %4.</translation>
    </message>
    <message>
        <source>Without a normal force there is no friction.</source>
        <translation>Ohne Normalkraft gibt es keine Reibung.</translation>
    </message>
    <message>
        <source>At rest there is no friction here.</source>
        <translation>In Ruhe gibt es hier keine Reibung.</translation>
    </message>
    <message>
        <source>Friction cannot be read here: elements or time steps are too coarse for it.</source>
        <translation>Die Reibung ist hier nicht ablesbar: Elemente oder Zeitschritte sind zu grob dafür.</translation>
    </message>
    <message>
        <source>The coefficient of friction is %1, all of it from the interface.</source>
        <translation>Die Reibungszahl ist %1 und kommt ganz aus der Grenzfläche.</translation>
    </message>
    <message>
        <source>The coefficient of friction is %1: %2 from the deformation of the elastomer and %3 from the interface.</source>
        <translation>Die Reibungszahl ist %1: %2 aus der Verformung des Elastomers und %3 aus der Grenzfläche.</translation>
    </message>
    <message>
        <source>There is no friction: an elastic body gives back all the work of its deformation.</source>
        <translation>Es gibt keine Reibung: Ein elastischer Körper gibt alle Arbeit seiner Verformung zurück.</translation>
    </message>
    <message>
        <source>The coefficient of friction is %1: a tangential force of %2, all of it from the deformation of the elastomer.</source>
        <translation>Die Reibungszahl ist %1: eine Tangentialkraft von %2, ganz aus der Verformung des Elastomers.</translation>
    </message>
    <message>
        <source>The mean of %1 lines is %2 ± %3 %.</source>
        <translation>Das Mittel über %1 Linien ist %2 ± %3 %.</translation>
    </message>
    <message>
        <source>This is region %1 of the friction curve, %2.</source>
        <translation>Das ist Bereich %1 der Reibungskurve, %2.</translation>
    </message>
    <message>
        <source>The picture still moves to the steady state, whose coefficient is %1.</source>
        <translation>Das Bild bewegt sich noch zum stationären Zustand mit der Reibungszahl %1.</translation>
    </message>
    <message>
        <source>The picture still moves to the steady state.</source>
        <translation>Das Bild bewegt sich noch zum stationären Zustand.</translation>
    </message>
    <message>
        <source>Note: %1.</source>
        <translation>Zu beachten: %1.</translation>
    </message>
    <message>
        <source>reference temperature</source>
        <translation>Bezugstemperatur</translation>
    </message>
    <message>
        <source>row of the topography</source>
        <translation>Zeile der Topographie</translation>
    </message>
    <message>
        <source>Levelling: what is subtracted from each row by least squares, a straight line, nothing, the mean or a parabola.</source>
        <translation>Ausrichten: was von jeder Zeile nach kleinsten Quadraten abgezogen wird, eine Gerade, nichts, der Mittelwert oder eine Parabel.</translation>
    </message>
    <message>
        <source>short-wave cut-off</source>
        <translation>kurze Grenzwellenlänge</translation>
    </message>
    <message>
        <source>S-filter: cut-off wavelength below which waves are removed, by the Gaussian filter of ISO 16610-21 from a measured surface, sharply from a spectrum; 0: none.</source>
        <translation>S-Filter: Grenzwellenlänge, unter der Wellen entfernt werden, aus einer gemessenen Oberfläche durch das Gauß-Filter nach ISO 16610-21, aus einem Spektrum scharf; 0: keine.</translation>
    </message>
    <message>
        <source>long-wave cut-off</source>
        <translation>lange Grenzwellenlänge</translation>
    </message>
    <message>
        <source>L-filter: cut-off wavelength above which waves are removed in the same way; 0: none, as friction usually needs, because long waves decide where the load is carried.</source>
        <translation>L-Filter: Grenzwellenlänge, über der Wellen ebenso entfernt werden; 0: keine, wie es Reibung meist verlangt, weil lange Wellen entscheiden, wo die Last getragen wird.</translation>
    </message>
    <message>
        <source>file format</source>
        <translation>Dateiformat</translation>
    </message>
    <message>
        <source>sliding direction</source>
        <translation>Gleitrichtung</translation>
    </message>
    <message>
        <source>missing points</source>
        <translation>fehlende Punkte</translation>
    </message>
    <message>
        <source>outlier limit</source>
        <translation>Ausreißergrenze</translation>
    </message>
    <message>
        <source>form removal</source>
        <translation>Formabzug</translation>
    </message>
    <message>
        <source>profile ends</source>
        <translation>Profilenden</translation>
    </message>
    <message>
        <source>line that slides</source>
        <translation>gleitende Linie</translation>
    </message>
    <message>
        <source>from the file</source>
        <translation>aus der Datei</translation>
    </message>
    <message>
        <source>mil</source>
        <translation>mil</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>Zoll</translation>
    </message>
    <message>
        <source>text table</source>
        <translation>Texttabelle</translation>
    </message>
    <message>
        <source>text: profile</source>
        <translation>Text: Profil</translation>
    </message>
    <message>
        <source>text: matrix of heights</source>
        <translation>Text: Höhenmatrix</translation>
    </message>
    <message>
        <source>text: points x y z</source>
        <translation>Text: Punkte x y z</translation>
    </message>
    <message>
        <source>Zygo</source>
        <translation>Zygo</translation>
    </message>
    <message>
        <source>Wyko, text</source>
        <translation>Wyko, Text</translation>
    </message>
    <message>
        <source>Surfer grid</source>
        <translation>Surfer-Gitter</translation>
    </message>
    <message>
        <source>NumPy</source>
        <translation>NumPy</translation>
    </message>
    <message>
        <source>read by Gwyddion</source>
        <translation>über Gwyddion</translation>
    </message>
    <message>
        <source>along the rows (x)</source>
        <translation>längs der Zeilen (x)</translation>
    </message>
    <message>
        <source>across the rows (y)</source>
        <translation>quer dazu (y)</translation>
    </message>
    <message>
        <source>refuse the file</source>
        <translation>Datei ablehnen</translation>
    </message>
    <message>
        <source>straight line</source>
        <translation>Ausgleichsgerade</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>mean height</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation>gespiegelt</translation>
    </message>
    <message>
        <source>blended</source>
        <translation>überblendet</translation>
    </message>
    <message>
        <source>random phases</source>
        <translation>Zufallsphasen</translation>
    </message>
    <message>
        <source>as they are</source>
        <translation>wie sie sind</translation>
    </message>
    <message>
        <source>as measured</source>
        <translation>wie gemessen</translation>
    </message>
    <message>
        <source>isotropic equivalent</source>
        <translation>isotrop gleichwertig</translation>
    </message>
    <message>
        <source>of a line, two-sided</source>
        <translation>einer Linie, zweiseitig</translation>
    </message>
    <message>
        <source>of a line, one-sided</source>
        <translation>einer Linie, einseitig</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>row %1 has no height at point %2; interpolate fills it</source>
        <translation>Zeile %1 hat an Punkt %2 keine Höhe; „interpolieren“ (interpolate) füllt sie</translation>
    </message>
    <message>
        <source>row %1 has %2 points without a height, the first is point %3; interpolate fills them</source>
        <translation>Zeile %1 hat %2 Punkte ohne Höhe, der erste ist Punkt %3; „interpolieren“ (interpolate) füllt sie</translation>
    </message>
    <message>
        <source>across the rows (along_y) needs a topography; the file has a single profile</source>
        <translation>quer zu den Zeilen (along_y) braucht eine Topographie; die Datei hat ein einziges Profil</translation>
    </message>
    <message>
        <source>across the rows (along_y) needs their distance, which the file does not state</source>
        <translation>quer zu den Zeilen (along_y) braucht deren Abstand, den die Datei nicht nennt</translation>
    </message>
    <message>
        <source>row %1 alone is the line</source>
        <translation>Zeile %1 allein ist die Linie</translation>
    </message>
    <message>
        <source>G′ (● measured)</source>
        <translation>G′ (● gemessen)</translation>
    </message>
    <message>
        <source>G″ (▲ measured)</source>
        <translation>G″ (▲ gemessen)</translation>
    </message>
    <message>
        <source>modulus</source>
        <translation>Modul</translation>
    </message>
    <message>
        <source>%1 is outside %2 to %3; --modulus-unit says what the file means</source>
        <translation>%1 liegt außerhalb von %2 bis %3; --modulus-unit sagt, was die Datei meint</translation>
    </message>
    <message>
        <source>the isotropic equivalent, C = π q C₂, of the measured surface</source>
        <translation>die isotrop gleichwertige Linie, C = π q C₂, der gemessenen Oberfläche</translation>
    </message>
    <message>
        <source>the heights of the row have only %1 levels, %2 apart, which is about as much as neighbours differ: the line is too steep by these steps; measure in finer steps, or remove waves shorter than %3 by surface.short_wave_cut</source>
        <translation>die Höhen der Zeile haben nur %1 Stufen im Abstand von %2, etwa so viel, wie sich Nachbarn unterscheiden: um diese Stufen ist die Linie zu steil; in feineren Stufen messen, oder Wellen kürzer als %3 mit surface.short_wave_cut entfernen</translation>
    </message>
    <message>
        <source>of %1 rows examined, %2 have heights in steps that are too coarse for their line</source>
        <translation>von %1 untersuchten Zeilen haben %2 Höhen in Stufen, die für ihre Linie zu grob sind</translation>
    </message>
    <message>
        <source>the profile is part of a circle with a radius of %1, which a parabola does not follow: measure a shorter piece, or remove the form by surface.long_wave_cut</source>
        <translation>das Profil ist Teil eines Kreises mit dem Radius %1, dem eine Parabel nicht folgt: ein kürzeres Stück messen, oder die Form mit surface.long_wave_cut entfernen</translation>
    </message>
    <message>
        <source>that the surface is isotropic is assumed: one profile cannot show it</source>
        <translation>dass die Oberfläche isotrop ist, wird angenommen: ein einzelnes Profil kann es nicht zeigen</translation>
    </message>
    <message>
        <source>that the surface is isotropic is assumed: %1 rows are too few to show it</source>
        <translation>dass die Oberfläche isotrop ist, wird angenommen: %1 Zeilen sind zu wenige, um es zu zeigen</translation>
    </message>
    <message>
        <source>the line is the isotropic equivalent, C = π q C₂, which has the height of the whole surface in the mean over all rows; its rms height is %1 times and its rms slope %2 times that of the line as measured</source>
        <translation>die Linie ist die isotrop gleichwertige, C = π q C₂, die im Mittel über alle Zeilen die Höhe der ganzen Oberfläche hat; ihre RMS-Höhe ist %1-mal und ihre RMS-Steigung %2-mal die der Linie wie gemessen</translation>
    </message>
    <message>
        <source>the shift used is the table of measured shifts</source>
        <translation>benutzt wird die Tabelle der gemessenen Verschiebungen</translation>
    </message>
    <message>
        <source>row %1 has %2 measured points; a line needs %3 or more</source>
        <translation>Zeile %1 hat %2 gemessene Punkte; eine Linie braucht mindestens %3</translation>
    </message>
    <message>
        <source>row %1 has %2 measured points; interpolate leaves such rows out and fills the gaps of the others</source>
        <translation>Zeile %1 hat %2 gemessene Punkte; „interpolieren“ (interpolate) lässt solche Zeilen weg und füllt die Lücken der übrigen</translation>
    </message>
    <message>
        <source>Tinted: from 5 to 95 % of the loss in complete contact, q C(q) G″(q v). The share is per decade of frequency, q² C G″, over its largest value.</source>
        <translation>Getönt: von 5 bis 95 % des Verlusts bei Vollkontakt, q C(q) G″(q v). Der Anteil gilt je Dekade der Frequenz, q² C G″, bezogen auf den größten Wert.</translation>
    </message>
    <message>
        <source>columns of deviations and set values, not read: %1</source>
        <translation>Spalten mit Abweichungen und Sollwerten, nicht gelesen: %1</translation>
    </message>
    <message>
        <source>%1 is a period of the oscillation: the frequency is 1 over it</source>
        <translation>%1 ist eine Periodendauer der Schwingung: Die Frequenz ist 1 durch sie</translation>
    </message>
    <message>
        <source>and %1 seem to be the same quantity; take one of them out, or say with %2 which is meant</source>
        <translation>und %1 scheinen dieselbe Größe zu sein; eine davon herausnehmen oder mit %2 sagen, welche gemeint ist</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is not understood beside the name of a modulus; name the column after the modulus alone, or say with %2 which is meant</source>
        <translation>„%1“ ist neben dem Namen eines Moduls nicht verständlich; die Spalte allein nach dem Modul benennen oder mit %2 sagen, welche gemeint ist</translation>
    </message>
    <message>
        <source>has the unit %1; a loss factor has none, or %</source>
        <translation>hat die Einheit %1; ein Verlustfaktor hat keine oder %</translation>
    </message>
    <message>
        <source>has the unit %1; an angle is in rad or deg</source>
        <translation>hat die Einheit %1; ein Winkel steht in rad oder deg</translation>
    </message>
    <message>
        <source>all marks in the numbers stand before three digits, so &apos;%1&apos; may separate decimals or thousands; write thousands without a mark, or one number with more or fewer decimals</source>
        <translation>alle Zeichen in den Zahlen stehen vor drei Ziffern, „%1“ kann also Dezimalstellen oder Tausender trennen; Tausender ohne Zeichen schreiben oder eine Zahl mit mehr oder weniger Dezimalstellen</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; does not name %3 columns; separate the names as the numbers are, or write each one without blanks, such as velocity_mm/s</source>
        <translation>Zeile %1: „%2“ benennt nicht %3 Spalten; die Namen trennen wie die Zahlen oder jeden ohne Leerzeichen schreiben, etwa velocity_mm/s</translation>
    </message>
    <message>
        <source>column %1: the unit %2 is not understood</source>
        <translation>Spalte %1: Die Einheit %2 ist nicht verständlich</translation>
    </message>
    <message>
        <source>column %1: bounds of the %2 are not read; give its error as a column such as mu_error, or take the column out</source>
        <translation>Spalte %1: Grenzen werden nicht gelesen (%2); den Fehler als Spalte wie mu_error angeben oder die Spalte herausnehmen</translation>
    </message>
    <message>
        <source>column %1: is it the %2? Name it so alone, with its unit in brackets, or take the column out</source>
        <translation>Spalte %1: Ist das gemeint: %2? Die Spalte nur so benennen, mit ihrer Einheit in Klammern, oder sie herausnehmen</translation>
    </message>
    <message>
        <source>columns %1 and %2: each may be the %3; give one such column, and a row for each measurement of mu</source>
        <translation>Spalten %1 und %2: Jede kann %3 sein; eine solche Spalte angeben und eine Zeile für jede Messung von mu</translation>
    </message>
    <message>
        <source>%1 in %2 contradicts itself: a wave number is in rad/m, a spatial frequency in cycles/m</source>
        <translation>%1 in %2 widerspricht sich: Eine Wellenzahl steht in rad/m, eine Ortsfrequenz in cycles/m</translation>
    </message>
    <message>
        <source>%1 in %2 is not a density over %3: over a wave number it is per rad/m, over a spatial frequency or a wavelength per cycles/m</source>
        <translation>%1 in %2 ist keine Dichte über %3: Über einer Wellenzahl ist sie je rad/m, über einer Ortsfrequenz oder Wellenlänge je cycles/m</translation>
    </message>
    <message>
        <source>its column %1 is not known as a spectrum; allowed are C1, C2 or psd, or another name with its unit</source>
        <translation>die Spalte %1 ist nicht als Spektrum bekannt; erlaubt sind C1, C2 oder psd oder ein anderer Name mit seiner Einheit</translation>
    </message>
    <message>
        <source>its column %1 is one-sided, which surface.spectrum_kind does not say</source>
        <translation>die Spalte %1 ist einseitig, was surface.spectrum_kind nicht sagt</translation>
    </message>
    <message>
        <source>its column %1 is two-sided, which surface.spectrum_kind does not say</source>
        <translation>die Spalte %1 ist zweiseitig, was surface.spectrum_kind nicht sagt</translation>
    </message>
    <message>
        <source>%1 may count into the material; say %2 where it does not, and set surface.contact_side to valleys as well where it does</source>
        <translation>%1 kann ins Material zählen; sonst hier %2 angeben, und wenn es so ist, zusätzlich surface.contact_side auf valleys setzen</translation>
    </message>
    <message>
        <source>has no rows of numbers; line %1: the value in column %2 is missing</source>
        <translation>hat keine Zeilen mit Zahlen; Zeile %1: Der Wert in Spalte %2 fehlt</translation>
    </message>
    <message>
        <source>has no rows of numbers; line %1 has &apos;%2&apos; in front of its numbers: write each quantity in a column, with its name above it</source>
        <translation>hat keine Zeilen mit Zahlen; in Zeile %1 steht „%2“ vor den Zahlen: jede Größe in eine Spalte schreiben, mit ihrem Namen darüber</translation>
    </message>
    <message>
        <source>%1 as in the file</source>
        <translation>%1 wie in der Datei</translation>
    </message>
    <message>
        <source>column %1: is it the temperature of the rubber, and not of the track or the air? Name it temperature alone, with its unit in brackets, or take the column out</source>
        <translation>Spalte %1: Ist das die Temperatur des Gummis, nicht die der Bahn oder der Luft? Die Spalte nur temperature nennen, mit ihrer Einheit in Klammern, oder sie herausnehmen</translation>
    </message>
    <message>
        <source>column T: is it the temperature of the rubber? Give it as numbers with a unit, as in &quot;T (°C)&quot;, or take the column out</source>
        <translation>Spalte T: Ist das die Temperatur des Gummis? Sie als Zahlen mit einer Einheit angeben, wie in &quot;T (°C)&quot;, oder die Spalte herausnehmen</translation>
    </message>
    <message>
        <source>column s: is it the standard deviation of the coefficient of friction? Name it std, or take the column out</source>
        <translation>Spalte s: Ist das die Standardabweichung der Reibungszahl? Die Spalte std nennen oder herausnehmen</translation>
    </message>
    <message>
        <source>column %1: it is not known how many standard errors this is; give one standard error as mu_error, or take the column out</source>
        <translation>Spalte %1: Es ist nicht bekannt, wie viele Standardfehler das sind; einen Standardfehler als mu_error angeben oder die Spalte herausnehmen</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; may state the %3, but is not understood; write it as in &quot;%4&quot;, or take the line out and set %5</source>
        <translation>Zeile %1: „%2“ nennt vielleicht %3, wird aber nicht verstanden; wie in &quot;%4&quot; schreiben, oder die Zeile herausnehmen und %5 setzen</translation>
    </message>
    <message>
        <source>column %1: &apos;%2&apos; is not understood as a value with its error; write both as in &quot;0.31 ± 0.02&quot;, or in two columns, mu and mu_error</source>
        <translation>Spalte %1: „%2“ ist nicht als Wert mit Fehler verständlich; beide wie in &quot;0.31 ± 0.02&quot; oder in zwei Spalten schreiben, mu und mu_error</translation>
    </message>
    <message>
        <source>column %1: has errors in its cells, and %2 gives them, too; keep one of them</source>
        <translation>Spalte %1: hat Fehler in ihren Zellen, und %2 gibt sie ebenfalls an; nur eines davon behalten</translation>
    </message>
    <message>
        <source>column %1, in its cells: %2</source>
        <translation>Spalte %1, in ihren Zellen: %2</translation>
    </message>
    <message>
        <source>column %1: the errors in its cells are not used</source>
        <translation>Spalte %1: Die Fehler in ihren Zellen werden nicht verwendet</translation>
    </message>
    <message>
        <source>column %1: the factor %2 may multiply or divide the numbers; write the coefficients of friction without it</source>
        <translation>Spalte %1: Der Faktor %2 kann die Zahlen malnehmen oder teilen; die Reibungszahlen ohne ihn schreiben</translation>
    </message>
    <message>
        <source>column %1 has no unit here, and %2 elsewhere</source>
        <translation>Spalte %1 hat hier keine Einheit und sonst %2</translation>
    </message>
    <message>
        <source>column %1 has the unit %2 here, and %3 elsewhere</source>
        <translation>Spalte %1 hat hier die Einheit %2 und sonst %3</translation>
    </message>
    <message>
        <source>line %1: &apos;%2&apos; may state the %3, but is not understood; write it as &quot;name: value&quot;, or take the line out</source>
        <translation>Zeile %1: „%2“ nennt vielleicht %3, wird aber nicht verstanden; als &quot;Name: Wert&quot; schreiben oder die Zeile herausnehmen</translation>
    </message>
    <message>
        <source>its square root</source>
        <translation>ihre Wurzel</translation>
    </message>
    <message>
        <source>divided by %1 for one standard error</source>
        <translation>für einen Standardfehler durch %1 geteilt</translation>
    </message>
    <message>
        <source>%1, divided by %2 for one standard error</source>
        <translation>%1, für einen Standardfehler durch %2 geteilt</translation>
    </message>
    <message>
        <source>column %1: the force is proportional to the coefficient of friction, as a force of friction is; name it friction force, and give the normal force in a column normal_force or a line &quot;Normal force: %2 N&quot;</source>
        <translation>Spalte %1: Die Kraft ist proportional zur Reibungszahl, wie es eine Reibkraft ist; sie Reibkraft nennen und die Normalkraft in einer Spalte normal_force oder einer Zeile &quot;Normalkraft: %2 N&quot; angeben</translation>
    </message>
    <message>
        <source>line %1: the %2 is below 0, by a convention of signs; its magnitude is taken</source>
        <translation>Zeile %1 (%2): unter 0, nach einer Vorzeichenregel; der Betrag wird genommen</translation>
    </message>
    <message>
        <source>with a slip, the velocity of sliding is not the one above the table; give it for each row in a column, as in &quot;v (m/s)&quot;</source>
        <translation>Mit einem Schlupf ist die Gleitgeschwindigkeit nicht die über der Tabelle; sie für jede Zeile in einer Spalte angeben, wie &quot;v (m/s)&quot;</translation>
    </message>
    <message>
        <source>with a slip, the velocity of sliding may not be that of column %1; name that column sliding velocity where it is, or give the velocity of sliding</source>
        <translation>Mit einem Schlupf ist die Gleitgeschwindigkeit womöglich nicht die der Spalte %1; diese Spalte Gleitgeschwindigkeit nennen, wo sie es ist, oder die Gleitgeschwindigkeit angeben</translation>
    </message>
    <message>
        <source>the %1 is %2, which no test of rubber reaches; correct it or its unit, or leave it empty where it stands for a missing value</source>
        <translation>%1: %2, was keine Messung an Gummi erreicht; den Wert oder seine Einheit berichtigen, oder ihn leer lassen, wo er für einen fehlenden Wert steht</translation>
    </message>
    <message>
        <source>has no unit, and line %1 names '%2'; write the unit into the name, as in &quot;%3 (%4)&quot;</source>
        <translation>hat keine Einheit, und Zeile %1 nennt „%2“; die Einheit in den Namen schreiben, wie &quot;%3 (%4)&quot;</translation>
    </message>
    <message>
        <source>has no unit, and line %1 names '%2'; %3 says which is meant</source>
        <translation>hat keine Einheit, und Zeile %1 nennt „%2“; %3 sagt, welche gemeint ist</translation>
    </message>
    <message>
        <source>rows %1 and %2 have the velocity above the table, and no load, temperature or label tells them apart; give the velocity of each row in a column, as in &quot;v (m/s)&quot;</source>
        <translation>die Zeilen %1 und %2 haben die Geschwindigkeit über der Tabelle, und keine Last, Temperatur oder Bezeichnung unterscheidet sie; die Geschwindigkeit jeder Zeile in einer Spalte angeben, wie &quot;v (m/s)&quot;</translation>
    </message>
    <message>
        <source>has no coefficient of friction, and a force of friction without a normal force; give it in a column &quot;Fz (N)&quot;, or above the columns, as in &quot;Normal force: 30 N&quot;</source>
        <translation>hat keine Reibungszahl, und eine Reibkraft ohne Normalkraft; diese in einer Spalte &quot;Fz (N)&quot; angeben oder über den Spalten, wie &quot;Normalkraft: 30 N&quot;</translation>
    </message>
    <message>
        <source>has no column of the velocity; its columns are %1; name it as in &quot;v (m/s)&quot;, or write one velocity of all rows above them, as in &quot;Velocity: 10 mm/s&quot;</source>
        <translation>hat keine Spalte der Geschwindigkeit; die Spalten sind %1; eine nennen wie &quot;v (m/s)&quot; oder eine Geschwindigkeit aller Zeilen darüber schreiben, wie &quot;Geschwindigkeit: 10 mm/s&quot;</translation>
    </message>
    <message>
        <source>column %1: the %2 is below 0 in all rows, by a convention of signs; its magnitude is taken</source>
        <translation>Spalte %1 (%2): in allen Zeilen unter 0, nach einer Vorzeichenregel; der Betrag wird genommen</translation>
    </message>
    <message>
        <source>column %1 contradicts the forces: in the median it is %2 times the force of friction in column %3 over the normal force; it is read as the coefficient of friction</source>
        <translation>Spalte %1 widerspricht den Kräften: Im Median ist sie %2-mal die Reibkraft in Spalte %3 durch die Normalkraft; sie wird als Reibungszahl gelesen</translation>
    </message>
    <message>
        <source>the nominal pressure of %1 is a normal force of %2: pressure times the period of %3 times the width, for which the period is taken because none is given; results depend on it, so set load.width (with load.kind pressure)</source>
        <translation>der nominelle Druck von %1 ist eine Normalkraft von %2: Druck mal Periode von %3 mal Breite, für die die Periode genommen wird, weil keine angegeben ist; Ergebnisse hängen von ihr ab, also load.width setzen (mit load.kind pressure)</translation>
    </message>
    <message>
        <source>the nominal pressure of %1 is a normal force of %2: pressure times the period of %3 times the width of %4 (load.width)</source>
        <translation>der nominelle Druck von %1 ist eine Normalkraft von %2: Druck mal Periode von %3 mal Breite von %4 (load.width)</translation>
    </message>
    <message>
        <source>has friction in several states side by side (%1); write them one below the other, with a column that tells them apart, such as temperature</source>
        <translation>hat die Reibung in mehreren Zuständen nebeneinander (%1); sie untereinander schreiben, mit einer Spalte, die sie unterscheidet, etwa temperature</translation>
    </message>
    <message>
        <source>columns %1 to %2: repeated measurements of the coefficient of friction; each point is their mean, with a standard error from the scatter in all rows</source>
        <translation>Spalten %1 bis %2: wiederholte Messungen der Reibungszahl; jeder Punkt ist ihr Mittelwert, mit einem Standardfehler aus der Streuung in allen Zeilen</translation>
    </message>
    <message>
        <source>columns %1 to %2: repeated measurements of the coefficient of friction; each point is their mean</source>
        <translation>Spalten %1 bis %2: wiederholte Messungen der Reibungszahl; jeder Punkt ist ihr Mittelwert</translation>
    </message>
    <message>
        <source>column %1: force of friction; its magnitude over the normal force is the coefficient of friction</source>
        <translation>Spalte %1: Reibkraft; ihr Betrag, geteilt durch die Normalkraft, ist die Reibungszahl</translation>
    </message>
    <message>
        <source>line %1: %2 of the points below it (%3)</source>
        <translation>Zeile %1: %2 der Punkte darunter (%3)</translation>
    </message>
    <message>
        <source>line %1: %2 of all points (%3)</source>
        <translation>Zeile %1: %2 aller Punkte (%3)</translation>
    </message>
    <message>
        <source>the series does not follow the moduli: no relaxation has such a storage modulus together with such a loss modulus (Kramers and Kronig); check the columns, their units and the shifts</source>
        <translation>die Reihe folgt den Moduln nicht: keine Relaxation hat einen solchen Speichermodul zusammen mit einem solchen Verlustmodul (Kramers und Kronig); Spalten, Einheiten und Verschiebungen prüfen</translation>
    </message>
    <message>
        <source>shifts: all isotherms are fitted together by smooth moduli, because the sums of the shifts of neighbours differ from it by more than their errors</source>
        <translation>Verschiebungen: alle Isothermen sind gemeinsam durch glatte Moduln angepasst, weil die Summen der Verschiebungen von Nachbarn davon um mehr als ihre Fehler abweichen</translation>
    </message>
    <message>
        <source>line %1: the %2 is not used, because a column gives the %3; take the column out where the line says the load</source>
        <translation>Zeile %1 wird nicht verwendet (%2), weil eine Spalte die Last angibt (%3); wo die Zeile die Last angibt, die Spalte weglassen</translation>
    </message>
    <message>
        <source>%1: a normal force is that on one period of the line, so that %2 would be a nominal pressure of %3 on the period of %4 times the width of %5, while the scene has %6; where it is the force on a whole sample, give the nominal pressure of the test in its place</source>
        <translation>%1: eine Normalkraft ist die auf eine Periode der Linie, sodass %2 ein nomineller Druck von %3 auf der Periode von %4 mal der Breite von %5 wäre, während die Szene %6 hat; wo sie die Kraft auf eine ganze Probe ist, stattdessen den nominellen Druck der Messung angeben</translation>
    </message>
    <message>
        <source>the lines above the table state several loads; one normal force or one nominal pressure says the load</source>
        <translation>die Zeilen über der Tabelle nennen mehrere Lasten; nur eine Normalkraft oder ein nomineller Druck gibt die Last an</translation>
    </message>
    <message>
        <source>% of the value</source>
        <translation>% des Werts</translation>
    </message>
    <message>
        <source>share of the value</source>
        <translation>Anteil am Wert</translation>
    </message>
    <message>
        <source>percentage points</source>
        <translation>Prozentpunkte</translation>
    </message>
    <message>
        <source>the coefficients of friction are %1 to %2; name their unit in the header, as in "mu (%)" or "mu (1)"</source>
        <translation>die Reibungszahlen betragen %1 bis %2; ihre Einheit in der Kopfzeile angeben, etwa "mu (%)" oder "mu (1)"</translation>
    </message>
    <message>
        <source>The surface is %1 m long: if the file states a wrong unit of positions, surface.position_unit replaces it.</source>
        <translation>Die Oberfläche ist %1 m lang: Falls die Datei eine falsche Einheit der Orte angibt, ersetzt surface.position_unit sie.</translation>
    </message>
    <message>
        <source>The heights span %1 m: if the file states a wrong unit of heights, surface.height_unit replaces it.</source>
        <translation>Die Höhen umfassen %1 m: Falls die Datei eine falsche Einheit der Höhen angibt, ersetzt surface.height_unit sie.</translation>
    </message>
    <message>
        <source>%1 and %2 are angles; positions are needed in a unit of length</source>
        <translation>%1 und %2 sind Winkel; Orte werden in einer Längeneinheit gebraucht</translation>
    </message>
    <message>
        <source>is needed (profile, matrix or points): columns %1 and %2 of %3 are too different for heights of one matrix</source>
        <translation>wird gebraucht (profile, matrix oder points): die Spalten %1 und %2 von %3 sind zu verschieden für Höhen einer Matrix</translation>
    </message>
    <message>
        <source>wave numbers are %1, the spectrum is %2</source>
        <translation>Wellenzahlen sind %1, das Spektrum ist %2</translation>
    </message>
    <message>
        <source>spatial frequencies are %1, the spectrum is %2</source>
        <translation>Ortsfrequenzen sind %1, das Spektrum ist %2</translation>
    </message>
    <message>
        <source>wavelengths are %1, the spectrum is %2</source>
        <translation>Wellenlängen sind %1, das Spektrum ist %2</translation>
    </message>
    <message>
        <source>column %1 '%2' (in SI units)</source>
        <translation>Spalte %1 „%2“ (in SI-Einheiten)</translation>
    </message>
    <message>
        <source>column %1 '%2' (%3)</source>
        <translation>Spalte %1 „%2“ (%3)</translation>
    </message>
    <message>
        <source>the spectrum is of an isotropic area, per wave number q: h² = 2π ∫ C q dq</source>
        <translation>das Spektrum ist das einer isotropen Fläche je Wellenzahl q: h² = 2π ∫ C q dq</translation>
    </message>
    <message>
        <source>the spectrum is of an isotropic area, per spatial frequency f = 1/wavelength: h² = 2π ∫ C f df</source>
        <translation>das Spektrum ist das einer isotropen Fläche je Ortsfrequenz f = 1/Wellenlänge: h² = 2π ∫ C f df</translation>
    </message>
    <message>
        <source>the spectrum is one-sided, per wave number q: h² = ∫ C dq</source>
        <translation>das Spektrum ist einseitig, je Wellenzahl q: h² = ∫ C dq</translation>
    </message>
    <message>
        <source>the spectrum is one-sided, per spatial frequency f = 1/wavelength: h² = ∫ C df</source>
        <translation>das Spektrum ist einseitig, je Ortsfrequenz f = 1/Wellenlänge: h² = ∫ C df</translation>
    </message>
    <message>
        <source>the spectrum is two-sided, per wave number q: h² = 2 ∫ C dq</source>
        <translation>das Spektrum ist zweiseitig, je Wellenzahl q: h² = 2 ∫ C dq</translation>
    </message>
    <message>
        <source>the spectrum is two-sided, per spatial frequency f = 1/wavelength: h² = 2 ∫ C df</source>
        <translation>das Spektrum ist zweiseitig, je Ortsfrequenz f = 1/Wellenlänge: h² = 2 ∫ C df</translation>
    </message>
    <message>
        <source>the spectrum ends at waves of %1: longer ones of the line, which is %2 long, have no height</source>
        <translation>das Spektrum endet bei Wellen von %1: längere der Linie, die %2 lang ist, haben keine Höhe</translation>
    </message>
    <message>
        <source>the spectrum has waves up to %1: those longer than the line, which is %2 long, are left out</source>
        <translation>das Spektrum hat Wellen bis %1: jene, die länger sind als die Linie von %2, entfallen</translation>
    </message>
    <message>
        <source>the spectrum ends at waves of %1: shorter ones, down to %2 of %3 elements, have no height</source>
        <translation>das Spektrum endet bei Wellen von %1: kürzere, bis %2 bei %3 Elementen, haben keine Höhe</translation>
    </message>
    <message>
        <source>the spectrum has waves down to %1: those shorter than %2 are left out, because %3 elements do not represent them</source>
        <translation>das Spektrum hat Wellen bis hinab zu %1: jene, die kürzer sind als %2, entfallen, weil %3 Elemente sie nicht darstellen</translation>
    </message>
    <message>
        <source>%1 lines are too many: surface.row chooses row %2, which is one line; allowed is 0 or 1</source>
        <translation>%1 Linien sind zu viele: surface.row wählt Zeile %2, das ist eine Linie; erlaubt ist 0 oder 1</translation>
    </message>
    <message>
        <source>row %1: the coefficient of friction %2 is %3 times what the points beside it give; is its decimal mark right?</source>
        <translation>Zeile %1: die Reibungszahl %2 ist das %3-fache dessen, was die Punkte daneben ergeben; stimmt das Dezimalzeichen?</translation>
    </message>
    <message>
        <source>line %1: %2 is read as %3; the decimal mark of the table is a comma</source>
        <translation>Zeile %1: %2 wird als %3 gelesen; das Dezimalzeichen der Tabelle ist ein Komma</translation>
    </message>
    <message>
        <source>line %1: %2 is read as %3; the decimal mark of the table is a point</source>
        <translation>Zeile %1: %2 wird als %3 gelesen; das Dezimalzeichen der Tabelle ist ein Punkt</translation>
    </message>
    <message>
        <source>has results of another version of &apos;%1&apos; than %2; a table is of one version</source>
        <translation>hat Ergebnisse einer anderen Fassung von „%1“ als %2; eine Tabelle gilt für eine Fassung</translation>
    </message>
    <message>
        <source>The numbers of this scene exceed the range of a computer&apos;s numbers.</source>
        <translation>Die Zahlen dieser Szene übersteigen, was ein Rechner fassen kann.</translation>
    </message>
    <message>
        <source>No steady sliding was found at this load and velocity.</source>
        <translation>Bei dieser Last und Geschwindigkeit wurde kein stationäres Gleiten gefunden.</translation>
    </message>
</context>
<context>
    <name>scenes</name>
    <message>
        <source>Fig. 1</source>
        <translation>Abb. 1</translation>
    </message>
    <message>
        <source>Fig. 2</source>
        <translation>Abb. 2</translation>
    </message>
    <message>
        <source>Fig. 3</source>
        <translation>Abb. 3</translation>
    </message>
    <message>
        <source>Fig. 4</source>
        <translation>Abb. 4</translation>
    </message>
    <message>
        <source>Fig. 5</source>
        <translation>Abb. 5</translation>
    </message>
    <message>
        <source>Fig. 6</source>
        <translation>Abb. 6</translation>
    </message>
    <message>
        <source>Master curve</source>
        <translation>Masterkurve</translation>
    </message>
    <message>
        <source>Influence of the spacing</source>
        <translation>Einfluss des Elementabstands</translation>
    </message>
    <message>
        <source>A constant shear stress in contact</source>
        <translation>Konstante Schubspannung im Kontakt</translation>
    </message>
    <message>
        <source>A filled tread compound: thirteen arms</source>
        <translation>Gefüllte Laufflächenmischung: dreizehn Arme</translation>
    </message>
    <message>
        <source>A parabola</source>
        <translation>Parabel</translation>
    </message>
    <message>
        <source>A single wave excites a standard solid at a single frequency, so the friction curve is the loss modulus itself. Its peak lies where the wave number times velocity times relaxation time is 1.</source>
        <translation>Eine einzelne Welle regt den Standardkörper bei einer einzigen Frequenz an, daher ist die Reibungskurve der Verlustmodul selbst. Ihr Maximum liegt dort, wo Wellenzahl mal Geschwindigkeit mal Relaxationszeit 1 ist.</translation>
    </message>
    <message>
        <source>A step of velocity</source>
        <translation>Geschwindigkeitssprung</translation>
    </message>
    <message>
        <source>A step of velocity on one asperity</source>
        <translation>Geschwindigkeitssprung auf einer Rauheitsspitze</translation>
    </message>
    <message>
        <source>A tread compound at room temperature</source>
        <translation>Laufflächenmischung bei Raumtemperatur</translation>
    </message>
    <message>
        <source>A wedge</source>
        <translation>Keil</translation>
    </message>
    <message>
        <source>A wedge on a standard solid</source>
        <translation>Keil auf einem Standardkörper</translation>
    </message>
    <message>
        <source>At 283 K all relaxation times are some 2600 times as long as at 343 K, so the whole curve moves to lower velocities. Its shape stays: velocity times the shift is all that counts.</source>
        <translation>Bei 283 K sind alle Relaxationszeiten etwa 2600-mal so lang wie bei 343 K, daher rückt die ganze Kurve zu kleineren Geschwindigkeiten. Ihre Form bleibt: Es zählt allein Geschwindigkeit mal Verschiebung.</translation>
    </message>
    <message>
        <source>At half time the line stops, and friction does not vanish with the velocity: contact is still one-sided and pushes back, with about half of the force at first and with none after a relaxation time. Meanwhile the line sinks in as the rubber creeps around its summits, which is why the next start is harder.</source>
        <translation>Nach der halben Zeit bleibt die Linie stehen, und die Reibung verschwindet nicht mit der Geschwindigkeit: Der Kontakt ist noch einseitig und drückt zurück, sofort mit etwa der halben Kraft und nach einer Relaxationszeit nicht mehr. Inzwischen sinkt die Linie ein, während das Gummi um ihre Gipfel kriecht; deshalb ist das nächste Anfahren schwerer.</translation>
    </message>
    <message>
        <source>At half time the line turns back into the dents it has just left. Friction first falls short and then settles at the value of the mirrored line, which for one line is not quite the same.</source>
        <translation>Nach der halben Zeit kehrt die Linie in die Mulden zurück, die sie eben verlassen hat. Die Reibung ist erst zu klein und nimmt dann den Wert der gespiegelten Linie an, der bei einer einzelnen Linie nicht ganz derselbe ist.</translation>
    </message>
    <message>
        <source>Cold rubber</source>
        <translation>Kaltes Gummi</translation>
    </message>
    <message>
        <source>Contact shifts to the leading side as the velocity grows, while the indentation falls. Friction has a maximum where the distance slid in a relaxation time is 1.4 times the half-width of the contact at rest, and falls again.</source>
        <translation>Mit wachsender Geschwindigkeit wandert der Kontakt zur Vorderseite, und die Eindringung nimmt ab. Die Reibung hat ein Maximum, wo der Gleitweg in einer Relaxationszeit das 1,4-Fache der halben Kontaktbreite in Ruhe beträgt, und fällt dann wieder.</translation>
    </message>
    <message>
        <source>Each arm adds a shoulder to the curve, and the dashpot a last climb to the plateau of a Kelvin body. Set the viscosity (under “All”) to 0, and friction falls instead of reaching a plateau.</source>
        <translation>Jeder Arm gibt der Kurve eine Schulter und der Dämpfer einen letzten Anstieg zum Plateau eines Kelvin-Körpers. Mit der Viskosität 0 (unter „Alle“) fällt die Reibung, statt ein Plateau zu erreichen.</translation>
    </message>
    <message>
        <source>Elastic rubber has no friction</source>
        <translation>Elastisches Gummi hat keine Reibung</translation>
    </message>
    <message>
        <source>Figure 1: contact of a rough line and a viscoelastic elastomer</source>
        <translation>Abbildung 1: Kontakt einer rauen Linie mit einem viskoelastischen Elastomer</translation>
    </message>
    <message>
        <source>Figure 2: a typical dependence of friction on velocity</source>
        <translation>Abbildung 2: typische Abhängigkeit der Reibung von der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Friction over velocity, averaged over 200 lines: it grows, bends into a plateau, and falls. The curve of Eq. (11) lies on it up to the plateau.</source>
        <translation>Reibung über der Geschwindigkeit, gemittelt über 200 Linien: Sie wächst, biegt in ein Plateau ein und fällt. Die Kurve nach Gl. (11) liegt bis zum Plateau auf ihr.</translation>
    </message>
    <message>
        <source>Complete contact on a sine: one wave, one frequency</source>
        <translation>Vollkontakt auf einem Sinus: eine Welle, eine Frequenz</translation>
    </message>
    <message>
        <source>Complete contact: an exact answer</source>
        <translation>Vollkontakt: eine exakte Antwort</translation>
    </message>
    <message>
        <source>Local friction beside deformation</source>
        <translation>Lokale Reibung neben der Verformung</translation>
    </message>
    <message>
        <source>One Maxwell arm beside a spring: friction has one broad peak instead of a plateau, because at high velocity the rubber is a stiff elastic body. Make the arm (under “All”) weaker and the peak sinks.</source>
        <translation>Ein Maxwell-Arm neben einer Feder: Die Reibung hat ein breites Maximum statt eines Plateaus, denn bei hoher Geschwindigkeit ist das Gummi ein steifer elastischer Körper. Mit schwächerem Arm (unter „Alle“) sinkt das Maximum.</translation>
    </message>
    <message>
        <source>Only leading sides of summits are in contact: the rubber acts like a viscous fluid, and friction is the slope of the line there, times about 1.4. Change the modulus or the force: little happens.</source>
        <translation>Nur die Vorderseiten der Gipfel sind in Kontakt: Das Gummi wirkt wie eine viskose Flüssigkeit, und die Reibungszahl ist dort die Steigung der Linie mal etwa 1,4. Modul oder Kraft ändern: Es geschieht wenig.</translation>
    </message>
    <message>
        <source>Only the highest summits still touch, with tips that are smooth on the scale of the shortest wave. Raise the number of elements (under “All”): finer tips move the decrease to higher velocities.</source>
        <translation>Nur die höchsten Gipfel haben noch Kontakt, mit Kuppen, die auf der Skala der kürzesten Welle glatt sind. Die Zahl der Elemente (unter „Alle“) erhöhen: Feinere Kuppen verschieben die Abnahme zu höheren Geschwindigkeiten.</translation>
    </message>
    <message>
        <source>Oscillation through rest</source>
        <translation>Schwingung durch den Stillstand</translation>
    </message>
    <message>
        <source>The line has been pressed in for a very long time and is then pulled suddenly: contact has its full width at first, so friction begins above its steady value. It settles within a relaxation time or a sliding distance of one contact length, whichever is shorter, while the line is lifted.</source>
        <translation>Die Linie ist seit sehr langer Zeit eingedrückt und wird dann plötzlich gezogen: Der Kontakt hat zunächst seine volle Breite, daher beginnt die Reibung über ihrem stationären Wert. Sie stellt sich innerhalb einer Relaxationszeit oder eines Gleitwegs von einer Kontaktlänge ein, je nachdem, was kürzer ist; dabei hebt sich die Linie.</translation>
    </message>
    <message>
        <source>Region I: friction grows with velocity</source>
        <translation>Bereich I: Die Reibung wächst mit der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Region II: the bend</source>
        <translation>Bereich II: die Biegung</translation>
    </message>
    <message>
        <source>Region III: the plateau</source>
        <translation>Bereich III: das Plateau</translation>
    </message>
    <message>
        <source>Region IV: friction falls again</source>
        <translation>Bereich IV: Die Reibung fällt wieder</translation>
    </message>
    <message>
        <source>An example without a published source, relaxation times from 100 s to 10⁻¹⁰ s, a third of the measured tensile moduli each: friction climbs over ten decades of velocity. The glassy side is cut at 10⁻¹⁰ s, so the fall beyond about 10⁵ m/s belongs to the fit and not to the rubber.</source>
        <translation>Ein Beispiel ohne veröffentlichte Quelle, Relaxationszeiten von 100 s bis 10⁻¹⁰ s, je ein Drittel der gemessenen Zugmoduln: Die Reibung steigt über zehn Dekaden der Geschwindigkeit. Die Glasseite ist bei 10⁻¹⁰ s abgeschnitten, daher gehört der Abfall oberhalb von etwa 10⁵ m/s zur Anpassung und nicht zum Gummi.</translation>
    </message>
    <message>
        <source>Reversal</source>
        <translation>Umkehr</translation>
    </message>
    <message>
        <source>Rougher summits</source>
        <translation>Rauere Gipfel</translation>
    </message>
    <message>
        <source>Rougher valleys</source>
        <translation>Rauere Täler</translation>
    </message>
    <message>
        <source>Roughness with a roll-off</source>
        <translation>Rauheit mit Roll-off</translation>
    </message>
    <message>
        <source>In slow sliding a standard solid is soft and elastic, in fast sliding stiff and elastic, so friction vanishes at both ends. Compare with the wedge on the Kelvin body, where friction stays at its maximum.</source>
        <translation>Bei langsamem Gleiten ist ein Standardkörper weich und elastisch, bei schnellem steif und elastisch, daher verschwindet die Reibung an beiden Enden. Zum Vergleich der Keil auf dem Kelvin-Körper, wo die Reibung an ihrem Maximum bleibt.</translation>
    </message>
    <message>
        <source>Standard solid on a rough line</source>
        <translation>Standardkörper auf einer rauen Linie</translation>
    </message>
    <message>
        <source>Start from rest</source>
        <translation>Anfahren aus der Ruhe</translation>
    </message>
    <message>
        <source>Start on a standard solid</source>
        <translation>Anfahren auf einem Standardkörper</translation>
    </message>
    <message>
        <source>Stop and rest</source>
        <translation>Anhalten und Ruhen</translation>
    </message>
    <message>
        <source>Summits of the line dent the rubber, which comes back behind them; the colour shows the line load, force per length. Raise the velocity: contact withdraws to the leading sides.</source>
        <translation>Gipfel der Linie drücken sich in das Gummi, das hinter ihnen zurückkehrt; die Farbe zeigt die Linienlast, Kraft je Länge. Die Geschwindigkeit erhöhen: Der Kontakt zieht sich auf die Vorderseiten zurück.</translation>
    </message>
    <message>
        <source>The load is so high that the rubber fills every valley, and friction is 4 L η v times the squared rms slope over the force, exactly (η = G τ: viscosity). Raise the velocity until the first valleys open and the straight line ends.</source>
        <translation>Die Last ist so hoch, dass das Gummi jedes Tal füllt, und die Reibungszahl ist exakt 4 L η v mal das Quadrat der RMS-Steigung, geteilt durch die Kraft (η = G τ: Viskosität). Die Geschwindigkeit erhöhen, bis sich die ersten Täler öffnen und die Gerade endet.</translation>
    </message>
    <message>
        <source>The rubber no longer quite keeps up, and contact begins to leave the trailing sides of the summits. Within a decade of velocity the straight line bends into the plateau.</source>
        <translation>Das Gummi kommt nicht mehr ganz nach, und der Kontakt beginnt die Rückseiten der Gipfel zu verlassen. Innerhalb einer Dekade der Geschwindigkeit biegt die Gerade in das Plateau ein.</translation>
    </message>
    <message>
        <source>A straight flank presses the rubber down at one speed: the line load begins with a jump, grows to the tip and drops behind it; at high velocity it is even. Friction reaches the slope itself once nothing touches the trailing flank, and stays there.</source>
        <translation>Eine gerade Flanke drückt das Gummi überall gleich schnell ein: Die Linienlast beginnt mit einem Sprung, wächst bis zur Spitze und fällt dahinter ab; bei hoher Geschwindigkeit ist sie gleichmäßig. Die Reibungszahl erreicht die Steigung selbst, sobald nichts mehr die hintere Flanke berührt, und bleibt dort.</translation>
    </message>
    <message>
        <source>The series, an example without a published source, holds at 343 K; by the shift of another filled rubber (Hentschke and Plagge 2021) every arm is about 140 times as slow at 298 K, and friction at walking speed is that of a stiffer rubber. Move the temperature: the curve slides along the velocity without changing.</source>
        <translation>Die Reihe, ein Beispiel ohne veröffentlichte Quelle, gilt bei 343 K; mit der Verschiebung eines anderen gefüllten Gummis (Hentschke und Plagge 2021) ist jeder Arm bei 298 K etwa 140-mal so langsam, und die Reibung bei Schrittgeschwindigkeit ist die eines steiferen Gummis. Die Temperatur ändern: Die Kurve wandert unverändert längs der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The short waves lie in the valleys and the summits are smooth, so the slope in contact rises with the load. Friction at light load is far below that of the line with rough summits, at nearly the same spectrum.</source>
        <translation>Die kurzen Wellen liegen in den Tälern, und die Gipfel sind glatt, daher steigt die Steigung im Kontakt mit der Last. Bei kleiner Last liegt die Reibung weit unter der einer Linie mit rauen Gipfeln, bei fast demselben Spektrum.</translation>
    </message>
    <message>
        <source>The short waves stand on the summits, which touch first, so the slope in contact is high at a light load and falls as the load grows. The spectrum alone does not tell this line from one with rough valleys.</source>
        <translation>Die kurzen Wellen stehen auf den Gipfeln, die zuerst Kontakt haben, daher ist die Steigung im Kontakt bei kleiner Last groß und fällt mit wachsender Last. Das Spektrum allein unterscheidet diese Linie nicht von einer mit rauen Tälern.</translation>
    </message>
    <message>
        <source>The surface has long come back where the next summit meets it, and every contact is nearly the same at its front and at its back. Double the velocity: friction doubles with it.</source>
        <translation>Die Oberfläche ist längst zurückgekehrt, wo der nächste Gipfel auf sie trifft, und jeder Kontakt ist vorn und hinten fast gleich. Die Geschwindigkeit verdoppeln: Die Reibung verdoppelt sich mit.</translation>
    </message>
    <message>
        <source>The velocity swings through zero and back, and friction lags behind it: at the same velocity it differs between rising and falling velocity, as the rubber remembers its past. Slow the oscillation down and both branches come together.</source>
        <translation>Die Geschwindigkeit schwingt durch null und zurück, und die Reibung hinkt hinterher: Bei gleicher Geschwindigkeit ist sie bei steigender Geschwindigkeit eine andere als bei fallender, denn das Gummi erinnert sich an seine Vergangenheit. Bei langsamerer Schwingung kommen beide Äste zusammen.</translation>
    </message>
    <message>
        <source>Two arms and a dashpot</source>
        <translation>Zwei Arme und ein Dämpfer</translation>
    </message>
    <message>
        <source>Warm rubber</source>
        <translation>Warmes Gummi</translation>
    </message>
    <message>
        <source>Waves longer than a millimetre are all equally strong, so the line looks like many similar summits instead of one landscape. At the same rms height its slope is far larger, and so is friction.</source>
        <translation>Wellen über einem Millimeter sind alle gleich stark, daher sieht die Linie wie viele gleiche Gipfel aus statt wie eine Landschaft. Bei gleicher RMS-Höhe ist ihre Steigung weit größer und damit auch die Reibung.</translation>
    </message>
    <message>
        <source>Without a dashpot of its own the rubber answers at once with its stiff modulus and then relaxes. Friction first shoots to more than twice its steady value, then falls with the contact as the line is lifted.</source>
        <translation>Ohne eigenen Dämpfer antwortet das Gummi sofort mit seinem steifen Modul und relaxiert dann. Die Reibung schießt erst auf mehr als das Doppelte ihres stationären Werts und fällt dann mit dem Kontakt, während sich die Linie hebt.</translation>
    </message>
    <message>
        <source>Without memory every summit is pushed as much forward as back, and friction is exactly zero at any velocity. What remains in a measurement is the local friction of the interface.</source>
        <translation>Ohne Gedächtnis wird jeder Gipfel ebenso stark vorwärts wie rückwärts gedrückt, und die Reibung ist bei jeder Geschwindigkeit exakt null. In einer Messung bleibt die lokale Reibung der Grenzfläche.</translation>
    </message>
    <message>
        <source>One-sided contact</source>
        <translation>Einseitiger Kontakt</translation>
    </message>
    <message>
        <source>A single summit, seen closely: the rubber is pushed down in front of it and is still on its way up behind, so only the leading side is touched. Lower the velocity to 0.001 m/s: contact becomes even on both sides, and friction vanishes.</source>
        <translation>Ein einzelner Gipfel, aus der Nähe: Vor ihm wird das Gummi hinabgedrückt, hinter ihm ist es noch auf dem Weg nach oben, daher wird nur die Vorderseite berührt. Die Geschwindigkeit auf 0,001 m/s senken: Der Kontakt wird auf beiden Seiten gleich, und die Reibung verschwindet.</translation>
    </message>
    <message>
        <source>Pressed in and at rest</source>
        <translation>Eingedrückt und in Ruhe</translation>
    </message>
    <message>
        <source>Nothing slides, so there is no friction: the line rests on the summits that reach deepest, and the rubber between them stays flat. Raise the force: contacts grow in number and in length.</source>
        <translation>Nichts gleitet, daher gibt es keine Reibung: Die Linie ruht auf den Gipfeln, die am tiefsten reichen, und das Gummi dazwischen bleibt eben. Die Kraft erhöhen: Die Kontakte wachsen an Zahl und Länge.</translation>
    </message>
    <message>
        <source>Tyre on asphalt</source>
        <translation>Reifen auf Asphalt</translation>
    </message>
    <message>
        <source>Rubber on sandpaper</source>
        <translation>Gummi auf Schleifpapier</translation>
    </message>
    <message>
        <source>Shoe on concrete</source>
        <translation>Schuh auf Beton</translation>
    </message>
    <message>
        <source>Foundation and half-space</source>
        <translation>Bettung und Halbraum</translation>
    </message>
    <message>
        <source>Contact fraction over velocity</source>
        <translation>Kontaktanteil über der Geschwindigkeit</translation>
    </message>
    <message>
        <source>Everyday surfaces</source>
        <translation>Oberflächen des Alltags</translation>
    </message>
    <message>
        <source>Each stone is touched on its front side alone, because the rubber behind it comes back too late: this causes the friction. Wavelengths of some millimetres are those of road macrotexture (ISO 13473-1: 0.5 mm to 50 mm), the pressure is that of a car tyre, and the height, the moduli near the glass transition and the width of 2 mm that turns pressure into force are an example; shorter waves, with which slopes are not small any more, are left out.</source>
        <translation>Jeder Stein wird nur an seiner Vorderseite berührt, weil das Gummi dahinter zu spät zurückkommt: Daher kommt die Reibung. Wellenlängen von einigen Millimetern sind die der Makrotextur von Straßen (ISO 13473-1: 0,5 mm bis 50 mm), der Druck ist der eines Autoreifens, und die Höhe, die Moduln nahe dem Glasübergang und die Breite von 2 mm, die aus Druck Kraft macht, sind ein Beispiel; kürzere Wellen, mit denen Steigungen nicht mehr klein sind, fehlen.</translation>
    </message>
    <message>
        <source>Change the velocity: in slow sliding the rubber fills the valleys behind each tip and pushes from both sides, at a few centimetres per second it touches only the front of each tip. Grains of P80 paper are 0.2 mm wide on average (FEPA 43-1); the height, low enough that slopes stay small, and the rubber with its one relaxation time are an example.</source>
        <translation>Die Geschwindigkeit ändern: Langsam füllt das Gummi die Täler hinter jedem Gipfel und drückt von beiden Seiten, bei einigen Zentimetern in der Sekunde berührt es nur noch die Vorderseite jedes Gipfels. Körner von Papier P80 sind im Mittel 0,2 mm breit (FEPA 43-1); die Höhe, so niedrig, dass Steigungen klein bleiben, und das Gummi mit seiner einen Relaxationszeit sind ein Beispiel.</translation>
    </message>
    <message>
        <source>Slow creeping costs little and so does a fast slip: friction is highest where a ridge passes in the time in which the rubber relaxes, and a foot that begins to slip has less and less of it. All figures are an example for a soft sole under a person who stands on both feet; adhesion, which on clean dry concrete adds to this friction, is not included.</source>
        <translation>Langsames Kriechen kostet wenig, schnelles Rutschen ebenso: Die Reibung ist am größten, wo ein Grat in der Zeit vorbeikommt, in der das Gummi relaxiert, und ein Fuß, der zu rutschen beginnt, hat immer weniger davon. Alle Werte sind ein Beispiel für eine weiche Sohle unter einem Menschen, der auf beiden Füßen steht; Adhäsion, die auf sauberem trockenem Beton dazukommt, ist nicht enthalten.</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Limits and checks</source>
        <translation>Grenzfälle und Gegenproben</translation>
    </message>
    <message>
        <source>The four regions of friction</source>
        <translation>Die vier Bereiche der Reibung</translation>
    </message>
    <message>
        <source>Materials and temperature</source>
        <translation>Materialien und Temperatur</translation>
    </message>
    <message>
        <source>The basics</source>
        <translation>Die Grundlagen</translation>
    </message>
    <message>
        <source>Motions</source>
        <translation>Bewegungen</translation>
    </message>
    <message>
        <source>The contacts of one period climb together less than a tenth of the rms height: results depend on single summits and on the period.</source>
        <translation>Die Kontakte einer Periode steigen zusammen um weniger als ein Zehntel der RMS-Höhe: Ergebnisse hängen von einzelnen Gipfeln und von der Periode ab.</translation>
    </message>
    <message>
        <source>Friction of the one line that the picture shows, at every velocity of the curve.</source>
        <translation>Reibung der einen Linie, die das Bild zeigt, bei jeder Geschwindigkeit der Kurve.</translation>
    </message>
    <message>
        <source>Friction of the one line that the picture shows, without what the interface adds.</source>
        <translation>Reibung der einen Linie, die das Bild zeigt, ohne das, was die Grenzfläche hinzufügt.</translation>
    </message>
    <message>
        <source>Mean over random lines with the same statistics; the bars are the standard error of that mean, not the scatter of the lines.</source>
        <translation>Mittel über zufällige Linien mit derselben Statistik; die Balken sind der Standardfehler dieses Mittels, nicht die Streuung der Linien.</translation>
    </message>
    <message>
        <source>Mean over random lines of what the deformation costs, without what the interface adds.</source>
        <translation>Mittel über zufällige Linien dessen, was die Verformung kostet, ohne das, was die Grenzfläche hinzufügt.</translation>
    </message>
    <message>
        <source>The state that the picture shows. Drag it, or use the arrow keys, and the picture follows.</source>
        <translation>Der Zustand, den das Bild zeigt. Mit der Maus oder den Pfeiltasten verschieben: Das Bild folgt.</translation>
    </message>
    <message>
        <source>The steady state to which the picture still moves. Drag it, or use the arrow keys, and the picture follows.</source>
        <translation>Der stationäre Zustand, auf den das Bild noch zuläuft. Mit der Maus oder den Pfeiltasten verschieben: Das Bild folgt.</translation>
    </message>
    <message>
        <source>The motion at this moment, beside the curve of steady sliding.</source>
        <translation>Die Bewegung in diesem Augenblick, neben der Kurve des stationären Gleitens.</translation>
    </message>
    <message>
        <source>The moment that the picture shows.</source>
        <translation>Der Augenblick, den das Bild zeigt.</translation>
    </message>
    <message>
        <source>The state before the change; the new one is being computed.</source>
        <translation>Der Zustand vor der Änderung; der neue wird gerade berechnet.</translation>
    </message>
    <message>
        <source>How far friction changes where the same lines are computed with another setting.</source>
        <translation>Wie weit sich die Reibung ändert, wenn dieselben Linien mit einer anderen Einstellung berechnet werden.</translation>
    </message>
    <message>
        <source>Coefficient of friction: the tangential force that deforms the elastomer, over the normal force.</source>
        <translation>Reibungszahl: die Tangentialkraft, die das Elastomer verformt, durch die Normalkraft.</translation>
    </message>
    <message>
        <source>Coefficient of friction over the rms slope of the line.</source>
        <translation>Reibungszahl durch die RMS-Steigung der Linie.</translation>
    </message>
    <message>
        <source>Coefficient of friction as it is measured: what deforming the elastomer costs and local friction together.</source>
        <translation>Reibungszahl, wie sie gemessen wird: Verformungsanteil und lokale Reibung zusammen.</translation>
    </message>
    <message>
        <source>Share of the line&apos;s length that touches the elastomer.</source>
        <translation>Anteil der Länge der Linie, der das Elastomer berührt.</translation>
    </message>
    <message>
        <source>Rms slope of the line where it touches the elastomer.</source>
        <translation>RMS-Steigung der Linie, wo sie das Elastomer berührt.</translation>
    </message>
    <message>
        <source>How deep the lowest point of the line lies below the undeformed surface.</source>
        <translation>Wie tief der tiefste Punkt der Linie unter der unverformten Oberfläche liegt.</translation>
    </message>
    <message>
        <source>The force that sliding takes, on one period of the line.</source>
        <translation>Die Kraft, die das Gleiten braucht, auf eine Periode der Linie.</translation>
    </message>
    <message>
        <source>Power that sliding turns into heat.</source>
        <translation>Leistung, die das Gleiten in Wärme verwandelt.</translation>
    </message>
    <message>
        <source>Normal force over the area in contact, contact length times width.</source>
        <translation>Normalkraft durch die Fläche im Kontakt, Kontaktlänge mal Breite.</translation>
    </message>
    <message>
        <source>Velocity without a dimension: at 1 contacts become one-sided.</source>
        <translation>Geschwindigkeit ohne Dimension: Bei 1 werden die Kontakte einseitig.</translation>
    </message>
    <message>
        <source>Force without a dimension: at 1 contact becomes complete.</source>
        <translation>Kraft ohne Dimension: Bei 1 wird der Kontakt vollständig.</translation>
    </message>
    <message>
        <source>Force of one element of the elastomer: a spring and a dashpot side by side.</source>
        <translation>Kraft eines Elements des Elastomers: Feder und Dämpfer nebeneinander.</translation>
    </message>
    <message>
        <source>Force of an element in contact with a line that slides.</source>
        <translation>Kraft eines Elements im Kontakt mit einer gleitenden Linie.</translation>
    </message>
    <message>
        <source>The contact carries the normal force, which gives the indentation.</source>
        <translation>Der Kontakt trägt die Normalkraft; daraus folgt die Eindringung.</translation>
    </message>
    <message>
        <source>Tangential force: line load on slopes.</source>
        <translation>Tangentialkraft: Linienlast auf Steigungen.</translation>
    </message>
    <message>
        <source>Friction in slow sliding and partial contact.</source>
        <translation>Reibung bei langsamem Gleiten und teilweisem Kontakt.</translation>
    </message>
    <message>
        <source>Friction in slow sliding, from the slope where there is contact.</source>
        <translation>Reibung bei langsamem Gleiten, aus der Steigung im Kontakt.</translation>
    </message>
    <message>
        <source>How friction in slow sliding falls with the normal force.</source>
        <translation>Wie die Reibung bei langsamem Gleiten mit der Normalkraft fällt.</translation>
    </message>
    <message>
        <source>Friction in slow sliding and complete contact.</source>
        <translation>Reibung bei langsamem Gleiten und Vollkontakt.</translation>
    </message>
    <message>
        <source>Friction on the plateau: only rising slopes carry load.</source>
        <translation>Reibung auf dem Plateau: Nur steigende Flanken tragen Last.</translation>
    </message>
    <message>
        <source>Friction of a purely viscous contact.</source>
        <translation>Reibung eines rein viskosen Kontakts.</translation>
    </message>
    <message>
        <source>The law of the paper: it joins slow sliding, complete contact and the plateau; region IV is not in it. α = H/(1 + H); β falls from 2.7 at H = 0 to 1.3 at H = 1.</source>
        <translation>Das Gesetz der Arbeit: Es verbindet langsames Gleiten, Vollkontakt und Plateau; Bereich IV enthält es nicht. α = H/(1 + H); β fällt von 2,7 bei H = 0 auf 1,3 bei H = 1.</translation>
    </message>
    <message>
        <source>The law without dimensions.</source>
        <translation>Das Gesetz ohne Dimensionen.</translation>
    </message>
    <message>
        <source>line load</source>
        <translation>Linienlast</translation>
    </message>
    <message>
        <source>viscosity (G τ in Kelvin elements)</source>
        <translation>Viskosität (G τ in Kelvin-Elementen)</translation>
    </message>
    <message>
        <source>displacement of the surface</source>
        <translation>Verschiebung der Oberfläche</translation>
    </message>
    <message>
        <source>height of the line above its lowest point</source>
        <translation>Höhe der Linie über ihrem tiefsten Punkt</translation>
    </message>
    <message>
        <source>distance between elements</source>
        <translation>Abstand der Elemente</translation>
    </message>
    <message>
        <source>modulus of an arm</source>
        <translation>Modul eines Arms</translation>
    </message>
    <message>
        <source>relaxation time of an arm</source>
        <translation>Relaxationszeit eines Arms</translation>
    </message>
    <message>
        <source>stretch of the spring of an arm</source>
        <translation>Dehnung der Feder eines Arms</translation>
    </message>
    <message>
        <source>rms slope</source>
        <translation>RMS-Steigung</translation>
    </message>
    <message>
        <source>length in contact</source>
        <translation>Länge im Kontakt</translation>
    </message>
    <message>
        <source>wave number</source>
        <translation>Wellenzahl</translation>
    </message>
    <message>
        <source>spectral density of the line</source>
        <translation>Spektraldichte der Linie</translation>
    </message>
    <message>
        <source>factor of the relaxation times</source>
        <translation>Faktor der Relaxationszeiten</translation>
    </message>
    <message>
        <source>The slope in contact when few contacts are left.</source>
        <translation>Die Steigung im Kontakt, wenn wenige Kontakte übrig sind.</translation>
    </message>
    <message>
        <source>All curves fall on one, when they are shifted along velocity and friction.</source>
        <translation>Alle Kurven fallen auf eine, wenn man sie entlang Geschwindigkeit und Reibung verschiebt.</translation>
    </message>
    <message>
        <source>The same with the slope in contact in the velocity.</source>
        <translation>Dasselbe mit der Steigung im Kontakt in der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The rigid line and what is above it. It slides and does not deform.</source>
        <translation>Die starre Linie und was über ihr liegt. Sie gleitet und verformt sich nicht.</translation>
    </message>
    <message>
        <source>Springs and dashpots side by side, each for itself; arms are springs and dashpots in series beside them.</source>
        <translation>Federn und Dämpfer nebeneinander, jedes Paar für sich; Arme sind Federn und Dämpfer in Reihe daneben.</translation>
    </message>
    <message>
        <source>How many times slower or faster than in reality the picture moves; below the contact it can be chosen.</source>
        <translation>Um welchen Faktor sich das Bild langsamer oder schneller bewegt als die Wirklichkeit; unter dem Kontakt ist er wählbar.</translation>
    </message>
    <message>
        <source>The force with which the bodies press on each other, per length of the line. It is to a line what pressure is to an area.</source>
        <translation>Die Kraft, mit der die Körper aufeinander drücken, je Länge der Linie. Sie ist für eine Linie, was der Druck für eine Fläche ist.</translation>
    </message>
    <message>
        <source>The glow is brighter and deeper where the line load is larger. It does not show how deep stresses reach, which the model does not know.</source>
        <translation>Das Leuchten ist heller und tiefer, wo die Linienlast größer ist. Es zeigt nicht, wie tief Spannungen reichen: Das weiß das Modell nicht.</translation>
    </message>
    <message>
        <source>How long ago the elastomer was in contact at this place. It recovers within a few relaxation times.</source>
        <translation>Wie lange das Elastomer an dieser Stelle schon nicht mehr in Kontakt ist. Es erholt sich binnen weniger Relaxationszeiten.</translation>
    </message>
    <message>
        <source>What the dashpots and, in contact, the interface turn into heat, per length of the line; of the free surface, too, while it recovers.</source>
        <translation>Was die Dämpfer und im Kontakt die Grenzfläche in Wärme verwandeln, je Länge der Linie; auch von der freien Oberfläche, solange sie sich erholt.</translation>
    </message>
    <message>
        <source>The dot marks a contact that is too narrow for its colour to be seen at this size.</source>
        <translation>Der Punkt markiert einen Kontakt, der zu schmal ist, als dass seine Farbe in dieser Größe zu sehen wäre.</translation>
    </message>
    <message>
        <source>Heights are drawn this many times larger than lengths; true slopes are as many times flatter.</source>
        <translation>Höhen sind um diesen Faktor größer gezeichnet als Längen; wirkliche Steigungen sind um ihn flacher.</translation>
    </message>
    <message>
        <source>The place in the direction of sliding. The line repeats after its period.</source>
        <translation>Der Ort in Gleitrichtung. Die Linie wiederholt sich nach ihrer Periode.</translation>
    </message>
    <message>
        <source>0 is the surface of the elastomer where nothing has pressed on it.</source>
        <translation>0 ist die Oberfläche des Elastomers, wo nichts auf sie gedrückt hat.</translation>
    </message>
    <message>
        <source>Of deformation and interface together: friction force over normal force.</source>
        <translation>Von Verformung und Grenzfläche zusammen: Reibungskraft durch Normalkraft.</translation>
    </message>
    <message>
        <source>A local coefficient of 0.001 in contact is added to what the deformation costs, and shown apart as μ of the interface. The contact itself is not changed: compare it with the same scene without.</source>
        <translation>Eine lokale Reibungszahl von 0,001 im Kontakt kommt zum Verformungsanteil hinzu und wird als μ der Grenzfläche getrennt angezeigt. Der Kontakt selbst ändert sich nicht: mit derselben Szene ohne sie vergleichen.</translation>
    </message>
    <message>
        <source>At 393 K the rubber relaxes about 15 times as fast as at 343 K, and the plateau is reached only at a higher velocity. The constants are those of a measured filled rubber: C₁ 4.41, C₂ 137.64 K, Tᵣ 343.15 K.</source>
        <translation>Bei 393 K relaxiert das Gummi etwa 15-mal so schnell wie bei 343 K, und das Plateau wird erst bei höherer Geschwindigkeit erreicht. Die Konstanten sind die eines gemessenen gefüllten Gummis: C₁ 4,41; C₂ 137,64 K; Tᵣ 343,15 K.</translation>
    </message>
    <message>
        <source>At half time the line slides twice as fast: friction jumps at once with the viscous forces, then relaxes as contact shrinks. The predicted rate is 1/τ + v/ℓ with ℓ the length of a contact; on a rough line it is a guide.</source>
        <translation>Nach der halben Zeit gleitet die Linie doppelt so schnell: Die Reibung springt sofort mit den viskosen Kräften und relaxiert dann, während der Kontakt schrumpft. Die vorhergesagte Rate ist 1/τ + v/ℓ mit der Länge ℓ eines Kontakts; auf einer rauen Linie ist sie ein Anhalt.</translation>
    </message>
    <message>
        <source>Each length in contact carries the same tangential load, so this part of friction follows the contact length and falls with velocity. The deformation part rises meanwhile: lower the velocity until both readings above the picture are equal.</source>
        <translation>Jede Länge im Kontakt trägt dieselbe Tangentiallast, daher folgt dieser Anteil der Reibung der Kontaktlänge und fällt mit der Geschwindigkeit. Der Verformungsanteil steigt dabei: Die Geschwindigkeit senken, bis beide Werte über dem Bild gleich sind.</translation>
    </message>
    <message>
        <source>One contact has one length, so friction relaxes along a single exponential at the rate 1/τ + v/ℓ, to about one per cent. On rough lines many contacts overlap and only the guide remains.</source>
        <translation>Ein einziger Kontakt hat eine einzige Länge, daher relaxiert die Reibung auf etwa ein Prozent genau längs einer einzigen Exponentialfunktion mit der Rate 1/τ + v/ℓ. Auf rauen Linien überlagern sich viele Kontakte, und es bleibt nur ein Anhalt.</translation>
    </message>
    <message>
        <source>The same roughness, rubber and load in two models: separate elements as points, and as the coloured line Persson&apos;s theory of a half-space, in which a summit also pulls down what lies around it. Friction is much the same, but that of the elements has its maximum at three times the velocity; and in slow sliding the elements touch four fifths of the line and the half-space one hundredth.</source>
        <translation>Dieselbe Rauheit, dasselbe Gummi und dieselbe Last in zwei Modellen. Punkte: getrennte Elemente. Farbige Linie: Perssons Theorie eines Halbraums, in dem ein Gipfel auch hinunterzieht, was um ihn liegt. Die Reibung ist fast dieselbe, nur hat die der Elemente ihr Maximum bei der dreifachen Geschwindigkeit; und bei langsamem Gleiten berühren die Elemente vier Fünftel der Linie und der Halbraum ein Hundertstel.</translation>
    </message>
</context>
</TS>
