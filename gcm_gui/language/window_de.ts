<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Words</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>log level</source>
        <translation>Protokollstufe</translation>
    </message>
    <message>
        <source> · %1 times</source>
        <translation> · %1-mal</translation>
    </message>
    <message>
        <source> · undone</source>
        <translation> · rückgängig</translation>
    </message>
    <message>
        <source>Your changes to the system are listed here.</source>
        <translation>Hier steht, was am System verändert wurde.</translation>
    </message>
    <message>
        <source>Nothing is wrong.</source>
        <translation>Es ist alles in Ordnung.</translation>
    </message>
    <message>
        <source>Activity</source>
        <translation>Aktivität</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Probleme</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Problems %1</source>
        <translation>Probleme %1</translation>
    </message>
    <message>
        <source> is lost</source>
        <translation> ist verloren</translation>
    </message>
    <message>
        <source> does not answer; its values may be old</source>
        <translation> antwortet nicht; die Werte können veraltet sein</translation>
    </message>
    <message>
        <source> is faulted</source>
        <translation> ist gestört</translation>
    </message>
    <message>
        <source> is not connected</source>
        <translation> ist nicht verbunden</translation>
    </message>
    <message>
        <source>…
For the whole result, use Copy as command</source>
        <translation>…
Die ganze Antwort: Als Befehl kopieren</translation>
    </message>
    <message>
        <source>Call a command</source>
        <translation>Befehl aufrufen</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Argument as JSON</source>
        <translation>Argument als JSON</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>Aufrufen</translation>
    </message>
    <message>
        <source>Not called: this command can move something; hold the button for 0.4 s</source>
        <translation>Nicht aufgerufen: den Knopf 0.4&#xa0;s halten, denn das kann etwas in Bewegung setzen</translation>
    </message>
    <message>
        <source>Ask again</source>
        <translation>Erneut fragen</translation>
    </message>
    <message>
        <source>Shows the argument as JSON text instead of a form</source>
        <translation>Das Argument als Text statt als Formular</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copies the command line that does the same in a terminal</source>
        <translation>Kopiert die Zeile, die im Terminal dasselbe tut</translation>
    </message>
    <message>
        <source>Add to the favourites</source>
        <translation>Zu den Favoriten</translation>
    </message>
    <message>
        <source>Adds a button for this command and argument</source>
        <translation>Legt einen Knopf für diesen Befehl mit diesem Argument an</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Calls the command repeatedly</source>
        <translation>Ruft ihn immer wieder auf</translation>
    </message>
    <message>
        <source>Call </source>
        <translation>Aufruf von </translation>
    </message>
    <message>
        <source>Loading the argument…</source>
        <translation>Argument wird erfragt…</translation>
    </message>
    <message>
        <source>Hold to call</source>
        <translation>Zum Aufruf halten</translation>
    </message>
    <message>
        <source>This command can move something: hold the button for 0.4 s, or press Ctrl+Enter twice</source>
        <translation>Das kann etwas in Bewegung setzen: den Knopf 0.4&#xa0;s halten oder zweimal Strg+Enter drücken</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Strg+Enter</translation>
    </message>
    <message>
        <source>This command can move something: press Ctrl+Enter again to call it</source>
        <translation>Nochmals Strg+Enter ruft auf: das kann etwas in Bewegung setzen</translation>
    </message>
    <message>
        <source>Calling…</source>
        <translation>Aufruf läuft…</translation>
    </message>
    <message>
        <source>Done in </source>
        <translation>Fertig nach </translation>
    </message>
    <message>
        <source>JSON of </source>
        <translation>JSON von </translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoriten</translation>
    </message>
    <message>
        <source>Favourite commands</source>
        <translation>Bevorzugte Befehle</translation>
    </message>
    <message>
        <source>Waiting for </source>
        <translation>Wartet auf </translation>
    </message>
    <message>
        <source>
This command can move something: hold the button for 0.4 s</source>
        <translation>
Das kann etwas in Bewegung setzen: den Knopf 0.4&#xa0;s halten</translation>
    </message>
    <message>
        <source>Show the command</source>
        <translation>Befehl zeigen</translation>
    </message>
    <message>
        <source>Remove from favourites</source>
        <translation>Aus den Favoriten entfernen</translation>
    </message>
    <message>
        <source>Calls a second</source>
        <translation>Aufrufe pro Sekunde</translation>
    </message>
    <message>
        <source>How many calls</source>
        <translation>Anzahl der Aufrufe</translation>
    </message>
    <message>
        <source>until stopped</source>
        <translation>bis Stopp</translation>
    </message>
    <message>
        <source> times</source>
        <translation> Mal</translation>
    </message>
    <message>
        <source>%1 call</source>
        <translation>%1 Aufruf</translation>
    </message>
    <message>
        <source>%1 calls</source>
        <translation>%1 Aufrufe</translation>
    </message>
    <message>
        <source>, %1 skipped: the previous call took too long</source>
        <translation>, %1 ausgelassen: der vorige dauerte zu lange</translation>
    </message>
    <message>
        <source>Hold to repeat</source>
        <translation>Zum Wiederholen halten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>This command can move something: hold the button for 0.4 s; the calls repeat until you release the button</source>
        <translation>Das kann etwas in Bewegung setzen: Aufrufe erfolgen, solange der Knopf gehalten wird, ab 0.4&#xa0;s</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>No candidate matches the filter.</source>
        <translation>Kein Kandidat passt zum Filter.</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Verbinden</translation>
    </message>
    <message>
        <source>Candidates for a connection</source>
        <translation>Kandidaten für eine Verbindung</translation>
    </message>
    <message>
        <source>Esc cancels</source>
        <translation>Esc bricht ab</translation>
    </message>
    <message>
        <source>Filter the candidates</source>
        <translation>Kandidaten filtern</translation>
    </message>
    <message>
        <source>Filter; Enter or 1 to 9 picks</source>
        <translation>Filter; Enter wählt, ebenso 1 bis 9</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>%1 is connected to %2. Other candidates:</source>
        <translation>%1 ist mit %2 verbunden. Womit es stattdessen verbunden werden könnte:</translation>
    </message>
    <message>
        <source>Provided interfaces for %1:</source>
        <translation>Womit %1 verbunden werden könnte:</translation>
    </message>
    <message>
        <source>Required interfaces for %1:</source>
        <translation>Was mit %1 verbunden werden könnte:</translation>
    </message>
    <message>
        <source>
Has %1 of the %2 commands and events that are needed.</source>
        <translation>
Hat %1 der %2 benötigten Befehle und Ereignisse.</translation>
    </message>
    <message>
        <source>replaces %1</source>
        <translation>ersetzt %1</translation>
    </message>
    <message>
        <source>%1 more: type a part of the name to find one</source>
        <translation>%1 weitere; zum Suchen tippen</translation>
    </message>
    <message>
        <source>None of %1 fits</source>
        <translation>Keiner von %1 passt</translation>
    </message>
    <message>
        <source>%1 more do not fit</source>
        <translation>%1 weitere passen gar nicht</translation>
    </message>
    <message>
        <source>is the current connection</source>
        <translation>ist schon die jetzige Verbindung</translation>
    </message>
    <message>
        <source> does not fit: </source>
        <translation> passt nicht: </translation>
    </message>
    <message>
        <source>Match by name and type</source>
        <translation>Nach Name und Typ zuordnen</translation>
    </message>
    <message>
        <source>%1 of %2 required interfaces have a candidate. Space checks a row, Enter connects all checked rows.</source>
        <translation>%1 von %2 benötigten Schnittstellen haben ein Gegenstück. Die Leertaste hakt an, Enter verbindet das Angehakte.</translation>
    </message>
    <message>
        <source>no available interface fits</source>
        <translation>nichts Vorhandenes passt</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eine von %1</translation>
    </message>
    <message>
        <source>Connect %1</source>
        <translation>Verbinden: %1</translation>
    </message>
    <message>
        <source> interfaces</source>
        <translation> Schnittstellen</translation>
    </message>
    <message>
        <source>Console output</source>
        <translation>Konsolenausgabe</translation>
    </message>
    <message>
        <source>Accepts the commands of gcm shell: try ls, watch, call … or help. Tab completes, Ctrl+C interrupts, Ctrl+R searches the history.</source>
        <translation>Die Sprache von gcm shell: zum Beispiel ls, watch, call … oder help. Tab ergänzt, Strg+C bricht ab, Strg+R sucht im Getippten.</translation>
    </message>
    <message>
        <source>Console line</source>
        <translation>Konsolenzeile</translation>
    </message>
    <message>
        <source>search &apos;%1&apos;:</source>
        <translation>Suche „%1“:</translation>
    </message>
    <message>
        <source>nothing with &apos;%1&apos;:</source>
        <translation>nichts mit „%1“:</translation>
    </message>
    <message>
        <source>… Ctrl+C</source>
        <translation>… Strg+C</translation>
    </message>
    <message>
        <source>%1 event</source>
        <translation>%1 Ereignis</translation>
    </message>
    <message>
        <source>%1 events</source>
        <translation>%1 Ereignisse</translation>
    </message>
    <message>
        <source>no event</source>
        <translation>kein Ereignis</translation>
    </message>
    <message>
        <source> · %1 a second</source>
        <translation> · %1 pro Sekunde</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · %1 verloren</translation>
    </message>
    <message>
        <source> · %1 waiting</source>
        <translation> · %1 wartend</translation>
    </message>
    <message>
        <source>No event has been raised since this page was opened.</source>
        <translation>Seit diese Seite offen ist, gab es kein Ereignis.</translation>
    </message>
    <message>
        <source>Source of the listed events</source>
        <translation>Wessen Ereignisse gezeigt werden</translation>
    </message>
    <message>
        <source>All components</source>
        <translation>Alle Komponenten</translation>
    </message>
    <message>
        <source>Selected component</source>
        <translation>Ausgewählte Komponente</translation>
    </message>
    <message>
        <source>Filter the events</source>
        <translation>Ereignisse filtern</translation>
    </message>
    <message>
        <source>Filter: words, from:robot/arm, -word</source>
        <translation>Filter: Wörter, from:robot/arm, -Wort</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The list is paused; new events are shown when the pause ends</source>
        <translation>Die Liste steht still; neue Ereignisse werden nach der Pause gezeigt</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Leeren</translation>
    </message>
    <message>
        <source>Select a component to see its events.</source>
        <translation>Eine Komponente auswählen, um ihre Ereignisse zu sehen.</translation>
    </message>
    <message>
        <source>the content cannot be encoded</source>
        <translation>der Inhalt lässt sich nicht kodieren</translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <translation>%1 wurde nicht gespeichert: %2</translation>
    </message>
    <message>
        <source>%1 call was refused, because the mailbox was full</source>
        <translation>%1 Aufruf wurde abgewiesen, weil das Postfach voll war</translation>
    </message>
    <message>
        <source>%1 calls were refused, because the mailbox was full</source>
        <translation>%1 Aufrufe wurden abgewiesen, weil das Postfach voll war</translation>
    </message>
    <message>
        <source>%1 event was lost</source>
        <translation>%1 Ereignis ging verloren</translation>
    </message>
    <message>
        <source>%1 events were lost</source>
        <translation>%1 Ereignisse gingen verloren</translation>
    </message>
    <message>
        <source>%1 of %2 calls wait</source>
        <translation>%1 von %2 Aufrufen warten</translation>
    </message>
    <message>
        <source>answers after </source>
        <translation>antwortet nach </translation>
    </message>
    <message>
        <source>Save a picture of the graph</source>
        <translation>Bild des Graphen speichern</translation>
    </message>
    <message>
        <source>SVG, scalable (*.svg)</source>
        <translation>SVG, beliebig groß (*.svg)</translation>
    </message>
    <message>
        <source>PNG, as on the screen (*.png)</source>
        <translation>PNG, wie zu sehen (*.png)</translation>
    </message>
    <message>
        <source>DOT, for Graphviz (*.dot)</source>
        <translation>DOT, für Graphviz (*.dot)</translation>
    </message>
    <message>
        <source>end the file name with .svg, .png or .dot to choose the format</source>
        <translation>der Dateiname muss auf .svg, .png oder .dot enden, um das Format zu wählen</translation>
    </message>
    <message>
        <source> saved</source>
        <translation> gespeichert</translation>
    </message>
    <message>
        <source>The picture of the graph is in the clipboard</source>
        <translation>Das Bild des Graphen ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>und %1 weitere</translation>
    </message>
    <message>
        <source> does not fit</source>
        <translation> passt nicht</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>wird verbunden …</translation>
    </message>
    <message>
        <source>System graph</source>
        <translation>Systemgraph</translation>
    </message>
    <message>
        <source>was </source>
        <translation>war </translation>
    </message>
    <message>
        <source>no components</source>
        <translation>keine Komponenten</translation>
    </message>
    <message>
        <source>Map of the graph</source>
        <translation>Übersichtskarte des Graphen</translation>
    </message>
    <message>
        <source>The frame shows the visible part; to move it, press Shift and an arrow key in the graph</source>
        <translation>Der Rahmen ist der sichtbare Teil; Umschalt und Pfeiltasten im Graphen verschieben ihn</translation>
    </message>
    <message>
        <source>Drag the frame to see another part  (M hides the map)</source>
        <translation>Den Rahmen ziehen, um einen anderen Teil zu sehen  (M blendet die Übersichtskarte aus)</translation>
    </message>
    <message>
        <source>Find in the graph</source>
        <translation>Im Graphen suchen</translation>
    </message>
    <message>
        <source>Component or interface</source>
        <translation>Komponente oder Schnittstelle</translation>
    </message>
    <message>
        <source>Previous match  (Shift+Enter)</source>
        <translation>Voriger Treffer  (Umschalt+Enter)</translation>
    </message>
    <message>
        <source>Next match  (Enter)</source>
        <translation>Nächster Treffer  (Enter)</translation>
    </message>
    <message>
        <source>End the search  (Esc)</source>
        <translation>Suche beenden  (Esc)</translation>
    </message>
    <message>
        <source>no match</source>
        <translation>kein Treffer</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>%1 gefunden</translation>
    </message>
    <message>
        <source>No event has been raised since this list was opened.</source>
        <translation>Seit dies offen ist, gab es kein Ereignis.</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Prozessor</translation>
    </message>
    <message>
        <source>Share of one core in the last second</source>
        <translation>Von einem Kern, in der letzten Sekunde</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Resident</source>
        <translation>Resident</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Difference from the clock of the GCM, with its uncertainty; above 0 if the clock of the process is ahead</source>
        <translation>Abweichung von der Uhr des GCM und ihre Unsicherheit; über 0 geht die Uhr vor</translation>
    </message>
    <message>
        <source>The fullest mailbox of the component holds %1 of at most %2 messages</source>
        <translation>%1 von %2 warten im vollsten Postfach der Komponente</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>keine Antwort</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Periode</translation>
    </message>
    <message>
        <source> · now </source>
        <translation> · jetzt </translation>
    </message>
    <message>
        <source>Planned rate, and actual rate in the last second</source>
        <translation>Wie oft sie laufen soll und wie oft sie es in der letzten Sekunde tat</translation>
    </message>
    <message>
        <source>Starts late by</source>
        <translation>Verspätung</translation>
    </message>
    <message>
        <source>%1 · max %2</source>
        <translation>%1 · max. %2</translation>
    </message>
    <message>
        <source>Delay of the cycles of the last second: at most %1 for half of them, %2 for 99 of 100, %3 for all</source>
        <translation>In der letzten Sekunde begann die Hälfte der Zyklen höchstens %1 nach ihrem Termin, 99 von 100 höchstens %2, alle höchstens %3</translation>
    </message>
    <message>
        <source>Skipped cycles</source>
        <translation>Übersprungene Zyklen</translation>
    </message>
    <message>
        <source>Since the task was started; a cycle is skipped if an earlier one took too long</source>
        <translation>Seit dem Start; ein Zyklus entfällt, wenn ein früherer zu lange dauerte</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Auslastung</translation>
    </message>
    <message>
        <source>Share of the period that is used for computation, mean of the last second</source>
        <translation>Welchen Teil ihrer Periode sie rechnet, Mittel der letzten Sekunde</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspektor</translation>
    </message>
    <message>
        <source>Forget this process</source>
        <translation>Prozess vergessen</translation>
    </message>
    <message>
        <source>Removes the process and its last state from the catalogue</source>
        <translation>Entfernt den Prozess und seinen letzten Stand aus dem Katalog</translation>
    </message>
    <message>
        <source>Interfaces</source>
        <translation>Schnittstellen</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Config</source>
        <translation>Konfiguration</translation>
    </message>
    <message>
        <source>This component has no interfaces.</source>
        <translation>Diese Komponente hat keine Schnittstellen.</translation>
    </message>
    <message>
        <source>This component has no state table.</source>
        <translation>Diese Komponente hat keine Zustandstabelle.</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Warum?</translation>
    </message>
    <message>
        <source>Why is </source>
        <translation>Warum ist </translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Trennen</translation>
    </message>
    <message>
        <source>Select a component in the catalogue or in the graph to see what it offers and needs.</source>
        <translation>Eine Komponente im Katalog oder im Graphen auswählen, um zu sehen, was sie anbietet und benötigt.</translation>
    </message>
    <message>
        <source> is not available.</source>
        <translation> ist nicht da.</translation>
    </message>
    <message>
        <source> since</source>
        <translation> seit</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Rechner</translation>
    </message>
    <message>
        <source>Process id</source>
        <translation>Prozess-ID</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Komponenten</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Grund</translation>
    </message>
    <message>
        <source> does not answer</source>
        <translation> antwortet nicht</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Klasse</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Störung</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Prozess</translation>
    </message>
    <message>
        <source>%1 client</source>
        <translation>%1 Client</translation>
    </message>
    <message>
        <source>%1 clients</source>
        <translation>%1 Clients</translation>
    </message>
    <message>
        <source>The log of all processes is listed here.</source>
        <translation>Hier steht, was die Prozesse protokollieren.</translation>
    </message>
    <message>
        <source>No record matches the filter.</source>
        <translation>Kein Eintrag passt zum Filter.</translation>
    </message>
    <message>
        <source>Recorded system</source>
        <translation>Aufgezeichnetes System</translation>
    </message>
    <message>
        <source>Lowest level that is shown</source>
        <translation>Niedrigste gezeigte Stufe</translation>
    </message>
    <message>
        <source>All levels</source>
        <translation>Alle Stufen</translation>
    </message>
    <message>
        <source>Info and above</source>
        <translation>Info und höher</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Warnungen und Fehler</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Filter the log</source>
        <translation>Protokoll filtern</translation>
    </message>
    <message>
        <source>Set level…</source>
        <translation>Stufe setzen…</translation>
    </message>
    <message>
        <source>Sets the lowest level that a process logs; this lasts until the process ends</source>
        <translation>Setzt die unterste Stufe, die ein Prozess protokolliert; das gilt, bis er endet</translation>
    </message>
    <message>
        <source>Clears this list; the processes and the GCM keep their records</source>
        <translation>Leert diese Liste; die Prozesse und der GCM behalten ihre Einträge</translation>
    </message>
    <message>
        <source> and above</source>
        <translation> und höher</translation>
    </message>
    <message>
        <source>There is no process</source>
        <translation>Es gibt keinen Prozess</translation>
    </message>
    <message>
        <source>%1 record</source>
        <translation>%1 Eintrag</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 Einträge</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Benötigt</translation>
    </message>
    <message>
        <source>Provided</source>
        <translation>Angeboten</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>%1 from %2, %3</source>
        <translation>%1 von %2, %3</translation>
    </message>
    <message>
        <source>Picture, </source>
        <translation>Bild, </translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1 Kanäle</translation>
    </message>
    <message>
        <source>a picture with encoding &apos;%1&apos; cannot be drawn; supported encodings: %2</source>
        <translation>ein Bild der Kodierung „%1“ kann nicht gezeichnet werden; möglich sind: %2</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is empty: width and height must be above 0</source>
        <translation>ein Bild von %1 Pixeln ist leer: Breite und Höhe müssen über 0 liegen</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large to be drawn: at most %2</source>
        <translation>ein Bild von %1 Pixeln ist zu groß zum Zeichnen: höchstens %2</translation>
    </message>
    <message>
        <source>a row of %1 pixels in %2 needs %3 bytes, but the field step is %4</source>
        <translation>eine Zeile von %1 Pixeln in %2 braucht %3 Bytes, aber das Feld step ist %4</translation>
    </message>
    <message>
        <source>%1 rows of %2 bytes do not match the %3 bytes of data</source>
        <translation>%1 Zeilen zu %2 Bytes passen nicht zu Daten von %3 Bytes</translation>
    </message>
    <message>
        <source> lost</source>
        <translation> verloren</translation>
    </message>
    <message>
        <source>none lost</source>
        <translation>keine verloren</translation>
    </message>
    <message>
        <source>%1 lost rows are marked</source>
        <translation>%1 verlorene markiert</translation>
    </message>
    <message>
        <source>Saved %1 row, %2, to %3</source>
        <translation>%1 Zeile, %2, gespeichert in %3</translation>
    </message>
    <message>
        <source>Saved %1 rows, %2, to %3</source>
        <translation>%1 Zeilen, %2, gespeichert in %3</translation>
    </message>
    <message>
        <source>%1 of %2 MB for samples</source>
        <translation>%1 von %2 MB für Messwerte</translation>
    </message>
    <message>
        <source>; of older samples, only the lowest and highest value of each 100 ms are kept</source>
        <translation>; von älteren bleibt je 100 ms der kleinste und der größte Wert</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
    <message>
        <source>min%1  max%2  mean%3  σ%4  rms%5  p-p%6  %7</source>
        <translation>min%1  max%2  mittel%3  σ%4  rms%5  p-p%6  %7</translation>
    </message>
    <message>
        <source>Close this plot</source>
        <translation>Diesen Plot schließen</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Neuer Plot</translation>
    </message>
    <message>
        <source>Add a plot below with the same time axis  (Ctrl+Shift+T)</source>
        <translation>Plot darunter, mit derselben Zeit  (Strg+Umschalt+T)</translation>
    </message>
    <message>
        <source>Time span of the plot</source>
        <translation>Wie weit der Plot zurückreicht</translation>
    </message>
    <message>
        <source>Back to the previous view  (Alt+Left)</source>
        <translation>Zurück zum zuvor Gezeigten  (Alt+Links)</translation>
    </message>
    <message>
        <source>Forward again  (Alt+Right)</source>
        <translation>Wieder vor  (Alt+Rechts)</translation>
    </message>
    <message>
        <source>Cursors A and B  (A, B; Delete)</source>
        <translation>Cursor A und B  (A, B; Entf)</translation>
    </message>
    <message>
        <source>Save the visible samples as CSV  (Ctrl+E)</source>
        <translation>Sichtbares als CSV speichern  (Strg+E)</translation>
    </message>
    <message>
        <source>Sweep: new samples overwrite the old curves from left to right  (S)</source>
        <translation>Durchlauf: die Kurven bleiben stehen und werden von links überschrieben  (S)</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>Ansicht anhalten</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Plots</translation>
    </message>
    <message>
        <source>Last </source>
        <translation>Letzte </translation>
    </message>
    <message>
        <source>Time span of the plot: </source>
        <translation>Wie weit der Plot zurückreicht: </translation>
    </message>
    <message>
        <source>Resume the view</source>
        <translation>Ansicht fortsetzen</translation>
    </message>
    <message>
        <source>Resume the view (Space)</source>
        <translation>Ansicht fortsetzen (Leertaste)</translation>
    </message>
    <message>
        <source>Pause the view; new data is still received (Space)</source>
        <translation>Ansicht anhalten, nicht die Daten (Leertaste)</translation>
    </message>
    <message>
        <source>Fit the visible part</source>
        <translation>Sichtbares einpassen</translation>
    </message>
    <message>
        <source>Only grow</source>
        <translation>Nur wachsen</translation>
    </message>
    <message>
        <source>Symmetric around 0</source>
        <translation>Symmetrisch um 0</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmisch</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistik</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Markierungen</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Durchlauf</translation>
    </message>
    <message>
        <source>Follow live data</source>
        <translation>Live-Daten folgen</translation>
    </message>
    <message>
        <source>Back to the previous view</source>
        <translation>Zurück zum zuvor Gezeigten</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>Wieder vor</translation>
    </message>
    <message>
        <source>A plot below</source>
        <translation>Plot darunter</translation>
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
        <source>Save the visible samples as CSV…</source>
        <translation>Sichtbares als CSV speichern…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>Anordnung öffnen…</translation>
    </message>
    <message>
        <source>Save layout of all plots…</source>
        <translation>Anordnung aller Plots speichern…</translation>
    </message>
    <message>
        <source>There is nothing to save as CSV: the plot shows no samples</source>
        <translation>Nichts als CSV zu speichern: der Plot zeigt keine Messwerte</translation>
    </message>
    <message>
        <source>Save the visible samples as CSV</source>
        <translation>Sichtbares als CSV speichern</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Save a picture of the plot</source>
        <translation>Bild des Plots speichern</translation>
    </message>
    <message>
        <source>PNG (*.png);;SVG (*.svg)</source>
        <translation>PNG (*.png);;SVG (*.svg)</translation>
    </message>
    <message>
        <source>Save the layout of all plots</source>
        <translation>Die Anordnung aller Plots speichern</translation>
    </message>
    <message>
        <source>Plot layout (*.plots.json)</source>
        <translation>Plot-Anordnung (*.plots.json)</translation>
    </message>
    <message>
        <source>Open a layout of plots</source>
        <translation>Plot-Anordnung öffnen</translation>
    </message>
    <message>
        <source>Plot layout (*.plots.json *.json)</source>
        <translation>Plot-Anordnung (*.plots.json *.json)</translation>
    </message>
    <message>
        <source> cannot be read: </source>
        <translation> kann nicht gelesen werden: </translation>
    </message>
    <message>
        <source> is not a layout of plots: </source>
        <translation> ist keine Plot-Anordnung: </translation>
    </message>
    <message>
        <source>Show another signal</source>
        <translation>Anderes Signal zeigen</translation>
    </message>
    <message>
        <source>In place of </source>
        <translation>Anstelle von </translation>
    </message>
    <message>
        <source>Close plots</source>
        <translation>Plots schließen</translation>
    </message>
    <message>
        <source>Close plot</source>
        <translation>Plot schließen</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>Plot %1</translation>
    </message>
    <message>
        <source>Plot </source>
        <translation>Plot </translation>
    </message>
    <message>
        <source>Select a value and press P, or drag it here</source>
        <translation>Einen Wert auswählen und P drücken oder ihn hierher ziehen</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Plot</translation>
    </message>
    <message>
        <source>Plot canvas</source>
        <translation>Zeichenfläche des Plots</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Fit the values again</source>
        <translation>Werte wieder einpassen</translation>
    </message>
    <message>
        <source>Follow live data again</source>
        <translation>Live-Daten wieder folgen</translation>
    </message>
    <message>
        <source> (double click)</source>
        <translation> (Doppelklick)</translation>
    </message>
    <message>
        <source>far outside of this axis: </source>
        <translation>weit außerhalb dieser Achse: </translation>
    </message>
    <message>
        <source>values of 0 and below cannot be shown on this axis: </source>
        <translation>Werte von 0 und darunter lassen sich auf dieser Achse nicht zeigen: </translation>
    </message>
    <message>
        <source> · %1 repeated</source>
        <translation> · %1 wiederholt</translation>
    </message>
    <message>
        <source> · %1 silent</source>
        <translation> · %1 stumm</translation>
    </message>
    <message>
        <source>Rate and lost rows: </source>
        <translation>Rate und verlorene Zeilen: </translation>
    </message>
    <message>
        <source>%1: %2, %3 row lost, %4 repeated</source>
        <translation>%1: %2, %3 Zeile verloren, %4 wiederholt</translation>
    </message>
    <message>
        <source>%1: %2, %3 rows lost, %4 repeated</source>
        <translation>%1: %2, %3 Zeilen verloren, %4 wiederholt</translation>
    </message>
    <message>
        <source>waiting for </source>
        <translation>wartet auf </translation>
    </message>
    <message>
        <source>connected for </source>
        <translation>besteht seit </translation>
    </message>
    <message>
        <source>round trip </source>
        <translation>hin und zurück </translation>
    </message>
    <message>
        <source>%1 calls and events</source>
        <translation>%1 Aufrufe und Ereignisse</translation>
    </message>
    <message>
        <source>mailbox: %1 of %2 used</source>
        <translation>Postfach: %1 von %2 belegt</translation>
    </message>
    <message>
        <source>%1 refused, %2 replaced, %3 events lost</source>
        <translation>%1 abgelehnt, %2 ersetzt, %3 Ereignisse verloren</translation>
    </message>
    <message>
        <source>%1 bytes: </source>
        <translation>%1 Bytes: </translation>
    </message>
    <message>
        <source>missing</source>
        <translation>fehlend</translation>
    </message>
    <message>
        <source>only running</source>
        <translation>nur laufend</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>geändert</translation>
    </message>
    <message>
        <source>stops or removes something that works</source>
        <translation>hält etwas an oder entfernt etwas, das läuft</translation>
    </message>
    <message>
        <source>= %1   + %2 only running   − %3 missing   ~ %4 changed</source>
        <translation>= %1   + %2 nur laufend   − %3 fehlend   ~ %4 geändert</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>geht nicht</translation>
    </message>
    <message>
        <source>The running system and its file</source>
        <translation>Laufendes System neben seiner Datei</translation>
    </message>
    <message>
        <source>Differences between the running system and its file</source>
        <translation>Unterschiede des laufenden Systems zu seiner Datei</translation>
    </message>
    <message>
        <source>Apply →</source>
        <translation>Anwenden →</translation>
    </message>
    <message>
        <source>Change the running system to match this line of the file</source>
        <translation>Das laufende System wird wie diese Zeile der Datei</translation>
    </message>
    <message>
        <source>← Update file</source>
        <translation>← Datei anpassen</translation>
    </message>
    <message>
        <source>Change this line of the file to match the running system</source>
        <translation>Diese Zeile der Datei wird wie das laufende System</translation>
    </message>
    <message>
        <source>Restore all…</source>
        <translation>Alles herstellen…</translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation>Schritte des Plans</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Continue after an error</source>
        <translation>Nach Fehlern fortfahren</translation>
    </message>
    <message>
        <source>Undo restore</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Carry out</source>
        <translation>Ausführen</translation>
    </message>
    <message>
        <source>%1: as in the file</source>
        <translation>%1: wie in der Datei</translation>
    </message>
    <message>
        <source>No system file is open.</source>
        <translation>Keine Systemdatei ist offen.</translation>
    </message>
    <message>
        <source>The running system matches the file.</source>
        <translation>Das laufende System entspricht der Datei.</translation>
    </message>
    <message>
        <source>Ctrl+S saves the running system; Ctrl+O opens a saved system.</source>
        <translation>Strg+S speichert das laufende System; Strg+O öffnet ein gespeichertes.</translation>
    </message>
    <message>
        <source>there is nothing to do</source>
        <translation>nichts zu tun</translation>
    </message>
    <message>
        <source>%1 step</source>
        <translation>%1 Schritt</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 Schritte</translation>
    </message>
    <message>
        <source>everything changes</source>
        <translation>alles ändert sich</translation>
    </message>
    <message>
        <source>will not touch </source>
        <translation>unberührt bleiben </translation>
    </message>
    <message>
        <source>%1 item</source>
        <translation>%1 Element</translation>
    </message>
    <message>
        <source>%1 items</source>
        <translation>%1 Elemente</translation>
    </message>
    <message>
        <source>Target %1: step %2 of %3</source>
        <translation>Ziel %1: Schritt %2 von %3</translation>
    </message>
    <message>
        <source>Target %1: %2 done, %3 failed, %4 remaining</source>
        <translation>Ziel %1: %2 erledigt, %3 gescheitert, %4 übrig</translation>
    </message>
    <message>
        <source>the previous state</source>
        <translation>wie zuvor</translation>
    </message>
    <message>
        <source>%1, modified since %2</source>
        <translation>%1, geändert seit %2</translation>
    </message>
    <message>
        <source>Saved to </source>
        <translation>Gespeichert in </translation>
    </message>
    <message>
        <source>Updated </source>
        <translation>Angepasst: </translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Tour, %1: %2</source>
        <translation>Rundgang, %1: %2</translation>
    </message>
    <message>
        <source>Catalogue</source>
        <translation>Katalog</translation>
    </message>
    <message>
        <source>Filter the catalogue</source>
        <translation>Katalog filtern</translation>
    </message>
    <message>
        <source>Filter: arm type:read state:active</source>
        <translation>Filter: arm type:read state:active</translation>
    </message>
    <message>
        <source>All words must be in the path; also -word, type:, state:, proc:, host:, /regex/  (Ctrl+F)</source>
        <translation>Alle Wörter müssen im Pfad stehen; auch -Wort, type:, state:, proc:, host:, /regex/  (Strg+F)</translation>
    </message>
    <message>
        <source>Nothing here yet.</source>
        <translation>Noch nichts da.</translation>
    </message>
    <message>
        <source>No row matches the filter.</source>
        <translation>Keine Zeile passt zum Filter.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close  (Esc)</source>
        <translation>Schließen  (Esc)</translation>
    </message>
    <message>
        <source>other type</source>
        <translation>anderer Typ</translation>
    </message>
    <message>
        <source>other kind</source>
        <translation>andere Art</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>Benötigt</translation>
    </message>
    <message>
        <source>Offered</source>
        <translation>Angeboten</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>, optional</source>
        <translation>, optional</translation>
    </message>
    <message>
        <source>good</source>
        <translation>in Ordnung</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>nicht erreicht</translation>
    </message>
    <message>
        <source>Neither interface has a member.</source>
        <translation>Keine Seite hat Befehle oder Ereignisse.</translation>
    </message>
    <message>
        <source>The needed and the offered members, side by side</source>
        <translation>Benötigtes und Angebotenes nebeneinander</translation>
    </message>
    <message>
        <source>Step %1, %2: %3</source>
        <translation>Schritt %1, %2: %3</translation>
    </message>
    <message>
        <source>Show side by side</source>
        <translation>Nebeneinander zeigen</translation>
    </message>
    <message>
        <source>fix: </source>
        <translation>Abhilfe: </translation>
    </message>
    <message>
        <source>Copy the fix: </source>
        <translation>Abhilfe kopieren: </translation>
    </message>
    <message>
        <source>Copied: </source>
        <translation>Kopiert: </translation>
    </message>
    <message>
        <source>Hide the comparison</source>
        <translation>Vergleich ausblenden</translation>
    </message>
    <message>
        <source>Select a required interface to see why it is connected or not</source>
        <translation>Eine benötigte Schnittstelle auswählen, um zu sehen, warum sie verbunden ist oder nicht</translation>
    </message>
    <message>
        <source> is not connected, and no available interface resembles it</source>
        <translation> ist nicht verbunden, und nichts Vorhandenes ähnelt ihr</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Nochmals</translation>
    </message>
    <message>
        <source>Copy report</source>
        <translation>Bericht kopieren</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>Den Bericht kopieren</translation>
    </message>
    <message>
        <source>Why? </source>
        <translation>Warum? </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>wird geprüft …</translation>
    </message>
    <message>
        <source>Try the connection again</source>
        <translation>Verbindung nochmals versuchen</translation>
    </message>
    <message>
        <source>Connect the two interfaces</source>
        <translation>Beide verbinden</translation>
    </message>
    <message>
        <source>The report is in the clipboard</source>
        <translation>Der Bericht ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>fails at step %1 of %2</source>
        <translation>scheitert bei Schritt %1 von %2</translation>
    </message>
    <message>
        <source>connected and working</source>
        <translation>verbunden und in Betrieb</translation>
    </message>
    <message>
        <source>nothing prevents the connection</source>
        <translation>nichts steht der Verbindung im Weg</translation>
    </message>
    <message>
        <source>refused at %1: %2</source>
        <translation>abgelehnt um %1: %2</translation>
    </message>
    <message>
        <source>         fix: </source>
        <translation>         Abhilfe: </translation>
    </message>
    <message>
        <source>  the same in a terminal: </source>
        <translation>  dasselbe im Terminal: </translation>
    </message>
    <message>
        <source>Values and plots continue, because they come directly from the processes.</source>
        <translation>Werte und Plots kommen direkt von ihren Prozessen und laufen weiter.</translation>
    </message>
    <message>
        <source>Grey parts show the state of %1 ago</source>
        <translation>Graues zeigt den Stand vor %1</translation>
    </message>
    <message>
        <source>Connected in %1 · Ctrl+Z undoes</source>
        <translation>Verbunden in %1 · Strg+Z macht rückgängig</translation>
    </message>
    <message>
        <source>Disconnected in %1 · Ctrl+Z undoes</source>
        <translation>Getrennt in %1 · Strg+Z macht rückgängig</translation>
    </message>
    <message>
        <source>Replaced in %1 · Ctrl+Z undoes</source>
        <translation>Ersetzt in %1 · Strg+Z macht rückgängig</translation>
    </message>
    <message>
        <source>Undone in %1</source>
        <translation>Rückgängig in %1</translation>
    </message>
    <message>
        <source>Forgotten</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Called in %1</source>
        <translation>Aufgerufen in %1</translation>
    </message>
    <message>
        <source>%1 logs %2 and above</source>
        <translation>%1 protokolliert %2 und höher</translation>
    </message>
    <message>
        <source>Replace </source>
        <translation>Ersatz für </translation>
    </message>
    <message>
        <source>Connect </source>
        <translation>Verbindung für </translation>
    </message>
    <message>
        <source> · no other provided interface fits · D disconnects · Esc cancels</source>
        <translation> · keine andere angebotene Schnittstelle passt · D trennt · Esc bricht ab</translation>
    </message>
    <message>
        <source> · no other required interface fits · D disconnects · Esc cancels</source>
        <translation> · keine andere benötigte Schnittstelle passt · D trennt · Esc bricht ab</translation>
    </message>
    <message>
        <source> · pick another provided interface · D disconnects · Esc cancels</source>
        <translation> · eine andere angebotene Schnittstelle wählen · D trennt · Esc bricht ab</translation>
    </message>
    <message>
        <source> · pick another required interface · D disconnects · Esc cancels</source>
        <translation> · eine andere benötigte Schnittstelle wählen · D trennt · Esc bricht ab</translation>
    </message>
    <message>
        <source> · no provided interface fits · Esc cancels</source>
        <translation> · keine angebotene Schnittstelle passt · Esc bricht ab</translation>
    </message>
    <message>
        <source> · no required interface fits · Esc cancels</source>
        <translation> · keine benötigte Schnittstelle passt · Esc bricht ab</translation>
    </message>
    <message>
        <source> · pick a provided interface · Esc cancels</source>
        <translation> · eine angebotene Schnittstelle wählen · Esc bricht ab</translation>
    </message>
    <message>
        <source> · pick a required interface · Esc cancels</source>
        <translation> · eine benötigte Schnittstelle wählen · Esc bricht ab</translation>
    </message>
    <message>
        <source>%1 process</source>
        <translation>%1 Prozess</translation>
    </message>
    <message>
        <source>%1 processes</source>
        <translation>%1 Prozesse</translation>
    </message>
    <message>
        <source>%1 component</source>
        <translation>%1 Komponente</translation>
    </message>
    <message>
        <source>%1 components</source>
        <translation>%1 Komponenten</translation>
    </message>
    <message>
        <source>%1 connection</source>
        <translation>%1 Verbindung</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 Verbindungen</translation>
    </message>
    <message>
        <source>Search or run   Ctrl+K</source>
        <translation>Suchen oder ausführen   Strg+K</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Ansicht anhalten</translation>
    </message>
    <message>
        <source>Finds all commands and all objects  (Ctrl+K)</source>
        <translation>Findet alles, was man tun kann und was es gibt  (Strg+K)</translation>
    </message>
    <message>
        <source>Pauses the display; new data is still received  (Space)</source>
        <translation>Hält die Zeichnung an, nie die Daten  (Leertaste)</translation>
    </message>
    <message>
        <source>Dark or light</source>
        <translation>Dunkel oder hell</translation>
    </message>
    <message>
        <source>No GCM found at </source>
        <translation>Kein GCM gefunden unter </translation>
    </message>
    <message>
        <source>searching every second</source>
        <translation>Suche jede Sekunde</translation>
    </message>
    <message>
        <source>GCM lost %1 ago</source>
        <translation>GCM vor %1 verloren</translation>
    </message>
    <message>
        <source>retrying </source>
        <translation>neuer Versuch: </translation>
    </message>
    <message>
        <source>Hosting the GCM on this machine</source>
        <translation>Eigener GCM auf diesem Rechner</translation>
    </message>
    <message>
        <source>GCM at </source>
        <translation>GCM unter </translation>
    </message>
    <message>
        <source>The global component manager (GCM) at %1 knows every process and makes the connections between the processes.</source>
        <translation>Der globale Komponentenmanager (GCM) unter %1 kennt jeden Prozess und stellt die Verbindungen her.</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 Problem</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 Probleme</translation>
    </message>
    <message>
        <source>Resume view</source>
        <translation>Ansicht fortsetzen</translation>
    </message>
    <message>
        <source>Search or run</source>
        <translation>Suchen oder ausführen</translation>
    </message>
    <message>
        <source>A command, or the name of an object</source>
        <translation>Was zu tun ist, oder ein Name als Ziel</translation>
    </message>
    <message>
        <source>No match.</source>
        <translation>Kein Treffer.</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;System</translation>
    </message>
    <message>
        <source>&amp;Plot</source>
        <translation>&amp;Plot</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>&amp;Graph</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Befehl für ein Terminal</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>Demo ausprobieren</translation>
    </message>
    <message>
        <source>Two processes with a simulated arm, on this machine.</source>
        <translation>Zwei Prozesse mit einem simulierten Arm, auf diesem Rechner.</translation>
    </message>
    <message>
        <source>Nothing is running yet.</source>
        <translation>Noch läuft nichts.</translation>
    </message>
    <message>
        <source>A process that joins this GCM appears here automatically.</source>
        <translation>Ein Prozess, der diesem GCM beitritt, erscheint hier von selbst.</translation>
    </message>
    <message>
        <source>To start a process, type in a terminal:</source>
        <translation>Um einen Prozess zu starten, im Terminal eingeben:</translation>
    </message>
    <message>
        <source>No GCM answers at %1.</source>
        <translation>Unter %1 antwortet kein GCM.</translation>
    </message>
    <message>
        <source>The window tries again every second until a GCM answers.</source>
        <translation>Das Fenster versucht es jede Sekunde, bis ein GCM antwortet.</translation>
    </message>
    <message>
        <source>To start a GCM, type in a terminal of that machine:</source>
        <translation>Um einen GCM zu starten, in einem Terminal jener Maschine eingeben:</translation>
    </message>
    <message>
        <source>Diff</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>&amp;Open a system file…</source>
        <translation>Systemdatei ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the running system</source>
        <translation>&amp;Laufendes System speichern</translation>
    </message>
    <message>
        <source>Save the running system &amp;as…</source>
        <translation>Laufendes System speichern &amp;unter…</translation>
    </message>
    <message>
        <source>&amp;Restore the system file…</source>
        <translation>System aus Datei &amp;herstellen…</translation>
    </message>
    <message>
        <source>&amp;Go back to a state</source>
        <translation>&amp;Zurück zu einem Stand</translation>
    </message>
    <message>
        <source>The system file of the demo cannot be read: </source>
        <translation>Die Systemdatei der Demo kann nicht gelesen werden: </translation>
    </message>
    <message>
        <source>A plan is running; the demo starts after the plan</source>
        <translation>Ein Plan wird gerade ausgeführt; die Demo kommt danach</translation>
    </message>
    <message>
        <source>the demo</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>The demo is already running</source>
        <translation>Die Demo läuft schon</translation>
    </message>
    <message>
        <source>Starting the demo: step %1 of %2</source>
        <translation>Demo wird gestartet: Schritt %1 von %2</translation>
    </message>
    <message>
        <source>The demo was not started: </source>
        <translation>Die Demo wurde nicht gestartet: </translation>
    </message>
    <message>
        <source>The demo runs: click a hollow port, then a port that lights up</source>
        <translation>Die Demo läuft: einen hohlen Anschluss anklicken, dann einen, der aufleuchtet</translation>
    </message>
    <message>
        <source>System files (*%1)</source>
        <translation>Systemdateien (*%1)</translation>
    </message>
    <message>
        <source>Open a system file</source>
        <translation>Systemdatei öffnen</translation>
    </message>
    <message>
        <source>Save the running system</source>
        <translation>Laufendes System speichern</translation>
    </message>
    <message>
        <source>Open a system file first: Ctrl+O</source>
        <translation>Zuerst eine Systemdatei öffnen: Strg+O</translation>
    </message>
    <message>
        <source>State at </source>
        <translation>Wie um </translation>
    </message>
    <message>
        <source>Nothing has changed yet</source>
        <translation>Noch nichts geändert</translation>
    </message>
    <message>
        <source>&amp;Find in the graph…</source>
        <translation>Im Graphen &amp;suchen…</translation>
    </message>
    <message>
        <source>Show &amp;all of the graph</source>
        <translation>&amp;Alles zeigen</translation>
    </message>
    <message>
        <source>&amp;Map of the graph</source>
        <translation>Übersichts&amp;karte des Graphen</translation>
    </message>
    <message>
        <source>&amp;Undo the last move</source>
        <translation>Letzte &amp;Verschiebung rückgängig machen</translation>
    </message>
    <message>
        <source>Nothing has been moved</source>
        <translation>Nichts wurde verschoben</translation>
    </message>
    <message>
        <source>&amp;Reset the layout of the graph</source>
        <translation>Anordnung des Graphen &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>All nodes are back at their automatic positions · Ctrl+Z undoes</source>
        <translation>Alle Knoten sind wieder an ihren automatischen Plätzen · Strg+Z macht rückgängig</translation>
    </message>
    <message>
        <source>Save a &amp;picture of the graph…</source>
        <translation>&amp;Bild des Graphen speichern…</translation>
    </message>
    <message>
        <source>&amp;Copy the picture of the graph</source>
        <translation>Bild des Graphen k&amp;opieren</translation>
    </message>
    <message>
        <source>Moved back</source>
        <translation>Zurückverschoben</translation>
    </message>
    <message>
        <source>Logo of Tendon</source>
        <translation>Logo von Tendon</translation>
    </message>
    <message>
        <source>Shows and controls a system of Tendon components.</source>
        <translation>Zeigt und steuert ein System aus Tendon-Komponenten.</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versionen</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothek</translation>
    </message>
    <message>
        <source>Terms of the library</source>
        <translation>Bedingungen der Bibliothek</translation>
    </message>
    <message>
        <source>Libraries in this program, and their licences</source>
        <translation>Bibliotheken in diesem Programm und ihre Lizenzen</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Versionen kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>About gcm-gui</source>
        <translation>Über gcm-gui</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Überall</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Umschalt+Tab</translation>
    </message>
    <message>
        <source>Go to the next or previous part</source>
        <translation>Zum nächsten, zum vorigen Teil</translation>
    </message>
    <message>
        <source>The menus</source>
        <translation>Die Menüs</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Leave the connect mode, a card or a field</source>
        <translation>Verlässt den Verbindungsmodus, eine Karte, ein Feld</translation>
    </message>
    <message>
        <source>In the graph</source>
        <translation>Im Graphen</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>Select the next component</source>
        <translation>Nächste Komponente auswählen</translation>
    </message>
    <message>
        <source>Zoom in, zoom out, show all</source>
        <translation>Näher, weiter weg, alles</translation>
    </message>
    <message>
        <source>1 … 9, Enter</source>
        <translation>1 … 9, Enter</translation>
    </message>
    <message>
        <source>While connecting: pick the candidate with this number, or the best candidate</source>
        <translation>Beim Verbinden: das Gegenstück mit dieser Nummer oder das beste wählen</translation>
    </message>
    <message>
        <source>In a plot</source>
        <translation>In einem Plot</translation>
    </message>
    <message>
        <source>Zoom in time; with Ctrl in values</source>
        <translation>Zoomen in der Zeit; mit Strg in den Werten</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Links, Rechts</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>In der Zeit verschieben</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Links</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Follow the data again</source>
        <translation>Den Daten wieder folgen</translation>
    </message>
    <message>
        <source>A, B, Delete</source>
        <translation>A, B, Entf</translation>
    </message>
    <message>
        <source>Place or remove the cursors</source>
        <translation>Cursor setzen, entfernen</translation>
    </message>
    <message>
        <source>In a plot&apos;s legend</source>
        <translation>In der Legende eines Plots</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Hide or show the curve</source>
        <translation>Kurve ausblenden, einblenden</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Remove the curve</source>
        <translation>Kurve entfernen</translation>
    </message>
    <message>
        <source>Show another signal instead</source>
        <translation>Stattdessen ein anderes Signal</translation>
    </message>
    <message>
        <source>In a form</source>
        <translation>In einem Formular</translation>
    </message>
    <message>
        <source>Call the command; if the command can move something, press these keys twice</source>
        <translation>Befehl aufrufen; ein zweites Mal, wo er etwas in Bewegung setzt</translation>
    </message>
    <message>
        <source>In the console</source>
        <translation>In der Konsole</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Completes</source>
        <translation>Ergänzt</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Strg+R</translation>
    </message>
    <message>
        <source>Searches the history</source>
        <translation>Sucht im Getippten</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+L</source>
        <translation>Strg+C, Strg+L</translation>
    </message>
    <message>
        <source>Interrupts; clears</source>
        <translation>Bricht ab; leert</translation>
    </message>
    <message>
        <source>Keys: </source>
        <translation>Tasten: </translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>The running system</source>
        <translation>Alles, was läuft</translation>
    </message>
    <message>
        <source>All processes with their components and interfaces appear here automatically; to find one, type into the filter.</source>
        <translation>Jeder Prozess, seine Komponenten und deren Schnittstellen erscheinen hier von selbst; zum Suchen in den Filter tippen.</translation>
    </message>
    <message>
        <source>Connect with two clicks</source>
        <translation>Mit zwei Klicks verbinden</translation>
    </message>
    <message>
        <source>Click a hollow port, then a port that lights up: this connects the two ports, and Ctrl+Z undoes the connection.</source>
        <translation>Einen hohlen Anschluss anklicken, dann einen, der aufleuchtet: beide sind verbunden, und Strg+Z macht es rückgängig.</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>Hineinsehen</translation>
    </message>
    <message>
        <source>Values, commands and events of the selected object are shown here; a click on a command opens a form to call it.</source>
        <translation>Ausgewähltes zeigt hier seine Werte, Befehle und Ereignisse, und ein Klick auf einen Befehl öffnet ein Formular, das ihn aufruft.</translation>
    </message>
    <message>
        <source>Plot it live</source>
        <translation>Live plotten</translation>
    </message>
    <message>
        <source>Select a value and press P: the plot shows all its samples, and you can zoom and measure while new ones arrive.</source>
        <translation>Einen Wert auswählen und P drücken: jeder Messwert wird gezeichnet, und man kann zoomen und messen, während weitere eintreffen.</translation>
    </message>
    <message>
        <source>Nothing is lost</source>
        <translation>Nichts geht verloren</translation>
    </message>
    <message>
        <source>Your actions are listed here; you can undo each of them, or copy its command line. Other tabs show problems, the log and a console.</source>
        <translation>Hier stehen die Aktionen; jede lässt sich rückgängig machen oder als Befehlszeile kopieren. Andere Reiter zeigen Probleme, Protokoll und eine Konsole.</translation>
    </message>
    <message>
        <source>Find everything by name</source>
        <translation>Alles über seinen Namen</translation>
    </message>
    <message>
        <source>Ctrl+K finds all commands and all objects. F1 shows the keys. The menu Help starts this tour again.</source>
        <translation>Strg+K findet alles, was man tun kann und was es gibt; F1 zeigt die Tasten und das Menü Hilfe diesen Rundgang.</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graph</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Nothing is connected.</source>
        <translation>Nichts ist verbunden.</translation>
    </message>
    <message>
        <source>Select an interface to connect it</source>
        <translation>Eine Schnittstelle auswählen, um sie zu verbinden</translation>
    </message>
    <message>
        <source> has no unconnected required interface</source>
        <translation> hat keine unverbundene benötigte Schnittstelle</translation>
    </message>
    <message>
        <source>Select a connected required interface to disconnect it</source>
        <translation>Eine verbundene benötigte Schnittstelle auswählen, um sie zu trennen</translation>
    </message>
    <message>
        <source>Select a command of a provided interface to call it</source>
        <translation>Einen Befehl einer angebotenen Schnittstelle auswählen, um ihn aufzurufen</translation>
    </message>
    <message>
        <source>Hosting the GCM at %1 – gcm-gui</source>
        <translation>Eigener GCM unter %1 – gcm-gui</translation>
    </message>
    <message>
        <source>GCM at %1 – gcm-gui</source>
        <translation>GCM unter %1 – gcm-gui</translation>
    </message>
    <message>
        <source>The GCM is back after </source>
        <translation>Der GCM ist zurück nach </translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>&amp;Verbinden…</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Trennen</translation>
    </message>
    <message>
        <source>&amp;Why is the interface connected, or not?</source>
        <translation>&amp;Warum verbunden oder nicht?</translation>
    </message>
    <message>
        <source>C&amp;all the command…</source>
        <translation>Befehl &amp;aufrufen…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Filter the catalogue</source>
        <translation>Katalog f&amp;iltern</translation>
    </message>
    <message>
        <source>&amp;Show in graph and catalogue</source>
        <translation>In &amp;Graph und Katalog zeigen</translation>
    </message>
    <message>
        <source>Search or &amp;run…</source>
        <translation>&amp;Suchen oder ausführen…</translation>
    </message>
    <message>
        <source>C&amp;onsole</source>
        <translation>&amp;Konsole</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Call the command</source>
        <translation>Befehl aufrufen</translation>
    </message>
    <message>
        <source>&amp;Plot the selection</source>
        <translation>Ausgewähltes &amp;plotten</translation>
    </message>
    <message>
        <source>&amp;New plot</source>
        <translation>&amp;Neuer Plot</translation>
    </message>
    <message>
        <source>Plot &amp;below, with the same time</source>
        <translation>Plot &amp;darunter, mit derselben Zeit</translation>
    </message>
    <message>
        <source>Close t&amp;his plot</source>
        <translation>Diesen Plot s&amp;chließen</translation>
    </message>
    <message>
        <source>Pause &amp;view</source>
        <translation>Ansicht an&amp;halten</translation>
    </message>
    <message>
        <source>Follow &amp;live data</source>
        <translation>&amp;Live-Daten folgen</translation>
    </message>
    <message>
        <source>Cursors &amp;A and B</source>
        <translation>Cursor &amp;A und B</translation>
    </message>
    <message>
        <source>&amp;Save the visible samples as CSV…</source>
        <translation>&amp;Sichtbares als CSV speichern…</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>&amp;Bild speichern…</translation>
    </message>
    <message>
        <source>&amp;Open a layout of plots…</source>
        <translation>Plot-Anordnung ö&amp;ffnen…</translation>
    </message>
    <message>
        <source>Save the layou&amp;t of plots…</source>
        <translation>Plot-Anordnun&amp;g speichern…</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Rundgang durch das Fenster</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Tasten</translation>
    </message>
    <message>
        <source>&amp;About gcm-gui</source>
        <translation>Ü&amp;ber gcm-gui</translation>
    </message>
    <message>
        <source>Layout for connecting</source>
        <translation>Anordnung zum Verbinden</translation>
    </message>
    <message>
        <source>Layout for plotting</source>
        <translation>Anordnung zum Plotten</translation>
    </message>
    <message>
        <source>Layout for operating</source>
        <translation>Anordnung zum Bedienen</translation>
    </message>
    <message>
        <source>Layout for diagnosing</source>
        <translation>Anordnung zur Diagnose</translation>
    </message>
    <message>
        <source>Panels can be moved</source>
        <translation>Bereiche sind verschiebbar</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Anordnung zurücksetzen</translation>
    </message>
    <message>
        <source> cannot be plotted, because it is not a number; select a column or a value of a state table</source>
        <translation> lässt sich nicht plotten, weil es keine Zahl ist; eine Spalte oder einen Wert einer Zustandstabelle auswählen</translation>
    </message>
    <message>
        <source>The first %1 of %2 numbers are plotted; select fewer numbers</source>
        <translation>Die ersten %1 von %2 Zahlen sind geplottet; weniger Zahlen auswählen</translation>
    </message>
    <message>
        <source>, and %1 more since the previous mark</source>
        <translation>, und %1 weitere seit der vorigen Markierung</translation>
    </message>
    <message>
        <source>call </source>
        <translation>Aufruf </translation>
    </message>
    <message>
        <source> by </source>
        <translation> durch </translation>
    </message>
    <message>
        <source>: refused</source>
        <translation>: abgelehnt</translation>
    </message>
    <message>
        <source> is back</source>
        <translation> ist zurück</translation>
    </message>
    <message>
        <source> disconnected</source>
        <translation> getrennt</translation>
    </message>
    <message>
        <source> is no longer connected to </source>
        <translation> ist nicht mehr verbunden mit </translation>
    </message>
    <message>
        <source> connected</source>
        <translation> verbunden</translation>
    </message>
    <message>
        <source> is connected to </source>
        <translation> ist verbunden mit </translation>
    </message>
    <message>
        <source>Smaller  (−)</source>
        <translation>Kleiner  (−)</translation>
    </message>
    <message>
        <source>Larger  (+)</source>
        <translation>Größer  (+)</translation>
    </message>
    <message>
        <source>Show all  (0)</source>
        <translation>Alles zeigen  (0)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Suspend</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Zum Starten halten</translation>
    </message>
    <message>
        <source>Hold to suspend</source>
        <translation>Zum Anhalten halten</translation>
    </message>
    <message>
        <source>Hold to stop</source>
        <translation>Zum Beenden halten</translation>
    </message>
    <message>
        <source>Hold to restart</source>
        <translation>Zum Neustart halten</translation>
    </message>
    <message>
        <source>Nothing was done: hold the button for 0.4 s</source>
        <translation>Nichts wurde getan: den Knopf 0.4 s lang halten</translation>
    </message>
    <message>
        <source>This order can move something: hold the button for 0.4 s</source>
        <translation>Es kann etwas in Bewegung setzen: den Knopf 0.4 s lang halten</translation>
    </message>
    <message>
        <source>This order can move something: hold the button for 0.4 s, or press Enter</source>
        <translation>Es kann etwas in Bewegung setzen: den Knopf 0.4 s lang halten oder die Eingabetaste drücken</translation>
    </message>
    <message>
        <source>Select a component to start, suspend, stop or restart it</source>
        <translation>Eine Komponente auswählen, um sie zu starten, anzuhalten, zu beenden oder neu zu starten</translation>
    </message>
    <message>
        <source>%1 has been restarted in %2</source>
        <translation>%1 ist in %2 neu gestartet</translation>
    </message>
    <message>
        <source>%1: %2 done in %3 · Ctrl+Z twice undoes</source>
        <translation>%1: %2 in %3 erledigt · zweimal Strg+Z macht es rückgängig</translation>
    </message>
    <message>
        <source>Why is the interface connected, or not?</source>
        <translation>Warum verbunden oder nicht?</translation>
    </message>
    <message>
        <source>Start or stop</source>
        <translation>Starten oder beenden</translation>
    </message>
    <message>
        <source>This order stops what the component does: hold the button for 0.4 s</source>
        <translation>Es beendet, was die Komponente tut: den Knopf 0.4 s lang halten</translation>
    </message>
    <message>
        <source>This order stops what the component does: hold the button for 0.4 s, or press Enter</source>
        <translation>Es beendet, was die Komponente tut: den Knopf 0.4 s lang halten oder die Eingabetaste drücken</translation>
    </message>
    <message>
        <source>%1 has not answered for %2 s: click, or press Enter, to ask again</source>
        <translation>%1 hat seit %2 s nicht geantwortet: ein Klick oder die Eingabetaste fragt noch einmal</translation>
    </message>
    <message>
        <source>no reply in %1 s · ask again</source>
        <translation>keine Antwort in %1 s · erneut fragen</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>%1 alt</translation>
    </message>
    <message>
        <source>the thread of %1</source>
        <translation>der Thread von %1</translation>
    </message>
    <message>
        <source>none of its own</source>
        <translation>kein eigener</translation>
    </message>
    <message>
        <source>its own</source>
        <translation>ein eigener</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>any</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>Wanted period</source>
        <translation>Soll-Periode</translation>
    </message>
    <message>
        <source>Longest period</source>
        <translation>Längste Periode</translation>
    </message>
    <message>
        <source>Mean of the last second</source>
        <translation>Mittel der letzten Sekunde</translation>
    </message>
    <message>
        <source>Median of the last second: half of the cycles start at most this late</source>
        <translation>Median der letzten Sekunde: die Hälfte der Zyklen beginnt höchstens so spät</translation>
    </message>
    <message>
        <source>99 of 100 start within</source>
        <translation>99 von 100 beginnen binnen</translation>
    </message>
    <message>
        <source>Latest start</source>
        <translation>Spätester Beginn</translation>
    </message>
    <message>
        <source>Computes for</source>
        <translation>Rechnet für</translation>
    </message>
    <message>
        <source>Longest computation</source>
        <translation>Längste Rechnung</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Thread</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Scheduling</translation>
    </message>
    <message>
        <source>Processors</source>
        <translation>Prozessoren</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Rename this plot</source>
        <translation>Diesen Plot umbenennen</translation>
    </message>
    <message>
        <source>Name; leave it empty for the default name</source>
        <translation>Name; leer: nach dem, was er zeigt</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>&amp;Rename this plot…</source>
        <translation>Diesen Plot &amp;umbenennen…</translation>
    </message>
    <message>
        <source>Keys of &amp;this part</source>
        <translation>Tasten dieses &amp;Teils</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederherstellen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Nichts wurde rückgängig gemacht, das wiederholt werden könnte</translation>
    </message>
    <message>
        <source>Starting and stopping cannot be redone: start or stop the component again, for example with F6 to F9</source>
        <translation>Starten und Beenden wird nicht wiederholt: die Komponente neu starten oder beenden, etwa mit F6 bis F9</translation>
    </message>
    <message>
        <source>%1 in its process</source>
        <translation>%1 in ihrem Prozess</translation>
    </message>
    <message>
        <source>%1 on the network</source>
        <translation>%1 im Netz</translation>
    </message>
    <message>
        <source>%1 in this window</source>
        <translation>%1 in diesem Fenster</translation>
    </message>
    <message>
        <source>; lost </source>
        <translation>; verloren: </translation>
    </message>
    <message>
        <source>Imported to </source>
        <translation>Importiert nach </translation>
    </message>
    <message>
        <source>Import a cisst file</source>
        <translation>Eine cisst-Datei importieren</translation>
    </message>
    <message>
        <source>&amp;Import a cisst file…</source>
        <translation>Eine cisst-Datei &amp;importieren…</translation>
    </message>
    <message>
        <source>Files of a cisst component manager (*.json)</source>
        <translation>Dateien eines cisst-Komponentenmanagers (*.json)</translation>
    </message>
    <message>
        <source>The process to which the components belong</source>
        <translation>Der Prozess, zu dem die Komponenten gehören</translation>
    </message>
    <message>
        <source>Connect to another machine</source>
        <translation>Mit einem anderen Rechner verbinden</translation>
    </message>
    <message>
        <source>Connect to another machine…</source>
        <translation>Mit einem anderen Rechner verbinden…</translation>
    </message>
    <message>
        <source>Connect to another &amp;machine…</source>
        <translation>Mit einem anderen &amp;Rechner verbinden…</translation>
    </message>
    <message>
        <source>Address of the GCM on that machine, such as robot1 or robot1:10705</source>
        <translation>Adresse des GCM auf jenem Rechner, etwa robot1 oder robot1:10705</translation>
    </message>
    <message>
        <source>Another window could not be started; type in a terminal: gcm-gui --gcm %1</source>
        <translation>Ein anderes Fenster ließ sich nicht starten; in einem Terminal eingeben: gcm-gui --gcm %1</translation>
    </message>
    <message>
        <source>Shows or hides processes that have been gone for half a minute</source>
        <translation>Prozesse, die seit einer halben Minute fort sind: zeigt oder verbirgt sie</translation>
    </message>
    <message>
        <source>gone (%1)</source>
        <translation>fort (%1)</translation>
    </message>
    <message>
        <source>%1 already exists: open it, or remove it before the import</source>
        <translation>%1 gibt es schon: öffnen, oder vor dem Import entfernen</translation>
    </message>
    <message>
        <source>%1 is shown in another window; this window stays open, because it hosts a GCM</source>
        <translation>%1 zeigt ein anderes Fenster; dieses betreibt einen GCM und bleibt offen</translation>
    </message>
    <message>
        <source>%1 · ask again</source>
        <translation>%1 · erneut fragen</translation>
    </message>
    <message>
        <source>Start the component</source>
        <translation>Die Komponente starten</translation>
    </message>
    <message>
        <source>Start %1 components</source>
        <translation>%1 Komponenten starten</translation>
    </message>
    <message>
        <source>Suspend the component</source>
        <translation>Die Komponente anhalten</translation>
    </message>
    <message>
        <source>Suspend %1 components</source>
        <translation>%1 Komponenten anhalten</translation>
    </message>
    <message>
        <source>Stop the component</source>
        <translation>Die Komponente beenden</translation>
    </message>
    <message>
        <source>Stop %1 components</source>
        <translation>%1 Komponenten beenden</translation>
    </message>
    <message>
        <source>Restart the component</source>
        <translation>Die Komponente neu starten</translation>
    </message>
    <message>
        <source>Restart %1 components</source>
        <translation>%1 Komponenten neu starten</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>gescheitert</translation>
    </message>
    <message>
        <source>left</source>
        <translation>übrig</translation>
    </message>
    <message>
        <source>Target %1: asking the processes for their classes…</source>
        <translation>Ziel %1: die Prozesse werden gefragt, was sie erzeugen können…</translation>
    </message>
    <message>
        <source>Target %1: %2; %3</source>
        <translation>Ziel %1: %2; %3</translation>
    </message>
    <message>
        <source>this GCM is too old to report which processes it has started</source>
        <translation>dieser GCM ist zu alt, um zu sagen, wen er gestartet hat</translation>
    </message>
    <message>
        <source>Start a GCM here</source>
        <translation>Hier einen GCM starten</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Rundgang</translation>
    </message>
    <message>
        <source>Starting a GCM; it keeps running when this window is closed</source>
        <translation>Ein GCM wird gestartet; er läuft weiter, wenn dieses Fenster geschlossen wird</translation>
    </message>
    <message>
        <source>%1 could not be started: check that it is installed</source>
        <translation>%1 konnte nicht gestartet werden: prüfen, ob es installiert ist</translation>
    </message>
    <message>
        <source>Current values from %1</source>
        <translation>Aktuelle Werte von %1</translation>
    </message>
    <message>
        <source>Reload everythi&amp;ng</source>
        <translation>Alles &amp;neu erfragen</translation>
    </message>
    <message>
        <source>Everything is loaded from the GCM again</source>
        <translation>Der GCM wird nach allem neu gefragt</translation>
    </message>
    <message>
        <source>No GCM answers; the window tries again each second</source>
        <translation>Es ist kein GCM da; er wird jede Sekunde gesucht</translation>
    </message>
    <message>
        <source>State / value</source>
        <translation>Zustand / Wert</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Connected to</source>
        <translation>Verbunden mit</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>Rows per second that arrive in this window. “–” means no subscription</source>
        <translation>Zeilen je Sekunde, die hier ankommen. „–“ bedeutet: kein Abonnement</translation>
    </message>
    <message>
        <source>For a value: time since its newest row was written. For a process: time since its state changed. “–” means unknown</source>
        <translation>Wert: Zeit, seit seine neueste Zeile geschrieben wurde. Prozess: Zeit, seit sich sein Zustand geändert hat. „–“ bedeutet: unbekannt</translation>
    </message>
    <message>
        <source>The connected interfaces; for a component, the connected components</source>
        <translation>Die Schnittstellen, bei einer Komponente die Komponenten, am anderen Ende</translation>
    </message>
    <message>
        <source>Columns of the catalogue</source>
        <translation>Spalten des Katalogs</translation>
    </message>
    <message>
        <source>Column: state and value</source>
        <translation>Spalte: Zustand und Wert</translation>
    </message>
    <message>
        <source>Column: rate</source>
        <translation>Spalte: Rate</translation>
    </message>
    <message>
        <source>Column: age</source>
        <translation>Spalte: Alter</translation>
    </message>
    <message>
        <source>Column: connected to</source>
        <translation>Spalte: verbunden mit</translation>
    </message>
    <message>
        <source>A scale of 0 would draw a flat line: choose another scale</source>
        <translation>Ein Faktor von 0 machte eine flache Linie daraus: einen anderen nehmen</translation>
    </message>
    <message>
        <source>The scale must lie between %1 and %2, with either sign</source>
        <translation>Der Faktor muss zwischen %1 und %2 liegen, mit beliebigem Vorzeichen</translation>
    </message>
    <message>
        <source>The offset must lie between -%1 and %1</source>
        <translation>Der Versatz muss zwischen -%1 und %1 liegen</translation>
    </message>
    <message>
        <source>The name of an axis has at most %1 letters</source>
        <translation>Der Name einer Achse hat höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>The name of an axis must be one line without control characters</source>
        <translation>Der Name einer Achse muss eine Zeile ohne Steuerzeichen sein</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>So zeigen</translation>
    </message>
    <message>
        <source>Scale, offset and axis of </source>
        <translation>Faktor, Versatz und Achse von </translation>
    </message>
    <message>
        <source>Curves with the same name here share one axis; a new name makes a new axis</source>
        <translation>Kurven mit derselben Achse teilen sie; ein eigener Name macht eine neue</translation>
    </message>
    <message>
        <source>Unscaled</source>
        <translation>Wie empfangen</translation>
    </message>
    <message>
        <source>Removes scale and offset, and uses the axis of the unit</source>
        <translation>Entfernt Skalierung und Versatz und nimmt die Achse der Einheit</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Achse</translation>
    </message>
    <message>
        <source>Axis of its unit</source>
        <translation>Die ihrer Einheit</translation>
    </message>
    <message>
        <source>The scale “%1” is not a number</source>
        <translation>Der Faktor „%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>The offset “%1” is not a number</source>
        <translation>Der Versatz „%1“ ist keine Zahl</translation>
    </message>
    <message>
        <source>Shown: value %1</source>
        <translation>Gezeigt: Wert %1</translation>
    </message>
    <message>
        <source>Shown unscaled</source>
        <translation>Wird wie empfangen gezeigt</translation>
    </message>
    <message>
        <source>; the values are not scaled</source>
        <translation>; Werte wie empfangen, nicht skaliert</translation>
    </message>
    <message>
        <source>Scale, offset and axis…</source>
        <translation>Faktor, Versatz und Achse…</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Ausblenden</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show another signal…</source>
        <translation>Anderes Signal zeigen…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>a curve has no path: give each curve a text &quot;path&quot;</source>
        <translation>eine Kurve hat keinen Pfad: jeder Kurve einen Text „path“ geben</translation>
    </message>
    <message>
        <source>scale and offset of %1 must be numbers</source>
        <translation>Faktor und Versatz von %1 müssen Zahlen sein</translation>
    </message>
    <message>
        <source>&quot;axis&quot; of %1 must be text in quotes</source>
        <translation>&quot;axis&quot; von %1 muss ein Text in Anführungszeichen sein</translation>
    </message>
    <message>
        <source>the list &quot;curves&quot; is missing</source>
        <translation>die Liste „curves“ fehlt</translation>
    </message>
    <message>
        <source>&quot;window&quot; must be above 0 and at most %1 s</source>
        <translation>„window“ muss über 0 und höchstens %1 s sein</translation>
    </message>
    <message>
        <source>plot %1: </source>
        <translation>Plot %1: </translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>kein JSON: %1</translation>
    </message>
    <message>
        <source>version %1 of plot layouts is not supported; this program supports version %2</source>
        <translation>Version %1 von Plot-Layouts wird nicht unterstützt; dieses Programm unterstützt Version %2</translation>
    </message>
    <message>
        <source>the file contains no plot: choose another file</source>
        <translation>die Datei enthält keinen Plot: eine andere Datei wählen</translation>
    </message>
    <message>
        <source>constructed</source>
        <translation>gebaut</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>bereit</translation>
    </message>
    <message>
        <source>active</source>
        <translation>aktiv</translation>
    </message>
    <message>
        <source>suspended</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>beendet</translation>
    </message>
    <message>
        <source>faulted</source>
        <translation>gestört</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>verbunden</translation>
    </message>
    <message>
        <source>pending</source>
        <translation>ausstehend</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>nicht verbunden</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>abgelehnt</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>verloren</translation>
    </message>
    <message>
        <source>alive</source>
        <translation>am Leben</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>startet</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>passt</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>neu gestartet</translation>
    </message>
    <message>
        <source>remap…</source>
        <translation>ersetzen…</translation>
    </message>
    <message>
        <source>same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>offered</source>
        <translation>angeboten</translation>
    </message>
    <message>
        <source>optional, not offered</source>
        <translation>optional, nicht angeboten</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>nicht benötigt</translation>
    </message>
    <message>
        <source>To undo &apos;%2&apos; (by %3, %4 ago), press Ctrl+Z again within %1 s</source>
        <translation>Strg+Z noch einmal innerhalb von %1 s nimmt „%2“ zurück, von %3 vor %4</translation>
    </message>
    <message>
        <source>; this undo can move something</source>
        <translation>; es zurückzunehmen kann etwas in Bewegung setzen</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>es gibt nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>process &apos;%1&apos; is lost%2; it is unknown whether the command was executed or will still be executed: check the component before you repeat the call</source>
        <translation>Prozess „%1“ ist verloren%2; ob der Befehl ausgeführt wurde oder noch wird, ist nicht bekannt: die Komponente prüfen, bevor der Aufruf wiederholt wird</translation>
    </message>
    <message>
        <source>this window cannot change anything: it was started with --read-only</source>
        <translation>dieses Fenster kann nichts ändern: es wurde mit --read-only gestartet</translation>
    </message>
    <message>
        <source>%1: current values from %2</source>
        <translation>%1: aktuelle Werte von %2</translation>
    </message>
    <message>
        <source>These are not the current values: %1 does not report the current values</source>
        <translation>Das sind nicht die jetzigen Werte: %1 nennt die jetzigen Werte nicht</translation>
    </message>
    <message>
        <source>left</source>
        <comment>of a process</comment>
        <translation>gegangen</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Scale, offset and axis</source>
        <translation>Faktor, Versatz und Achse</translation>
    </message>
    <message>
        <source>To be corrected: %1</source>
        <translation>Zu berichtigen: %1</translation>
    </message>
    <message>
        <source>put a space after each comma between numbers</source>
        <translation>hinter jedes Komma zwischen Zahlen ein Leerzeichen setzen</translation>
    </message>
    <message>
        <source>a number is missing in the list</source>
        <translation>in der Liste fehlt eine Zahl</translation>
    </message>
    <message>
        <source>it is not clear whether “%1” is one number or several: put semicolons between numbers</source>
        <translation>es ist nicht klar, ob „%1“ eine Zahl ist oder mehrere: Semikolons zwischen die Zahlen setzen</translation>
    </message>
    <message>
        <source>write a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2 schreiben</translation>
    </message>
    <message>
        <source>Nothing was pasted: %1</source>
        <translation>Nichts eingefügt: %1</translation>
    </message>
    <message>
        <source>expected one number, found %1</source>
        <translation>hierher gehört eine Zahl, und es sind %1</translation>
    </message>
    <message>
        <source>expected at most %2 numbers from this field on, found %1</source>
        <translation>es sind %1 Zahlen, und ab hier %2 Felder</translation>
    </message>
    <message>
        <source> or </source>
        <translation> oder </translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>eine Zahl fehlt</translation>
    </message>
    <message>
        <source>write %1: use a point as the decimal sign, and no separator between thousands</source>
        <translation>%1 schreiben: das Dezimalzeichen ist ein Punkt, und zwischen Tausendern steht nichts</translation>
    </message>
    <message>
        <source>write %1: use a point as the decimal sign</source>
        <translation>%1 schreiben: das Dezimalzeichen ist ein Punkt</translation>
    </message>
    <message>
        <source>write %1: use no separator between thousands</source>
        <translation>%1 schreiben: zwischen Tausendern steht nichts</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>%1 schreiben</translation>
    </message>
    <message>
        <source>write the number alone, without “%1”</source>
        <translation>nur die Zahl schreiben, ohne „%1“</translation>
    </message>
    <message>
        <source>write the number alone, in %1</source>
        <translation>nur die Zahl schreiben, in %1</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>eine ganze Zahl schreiben</translation>
    </message>
    <message>
        <source>the type of this field cannot hold this number</source>
        <translation>der Typ dieses Feldes fasst keine solche Zahl</translation>
    </message>
    <message>
        <source>write a number in digits</source>
        <translation>eine Zahl in Ziffern schreiben</translation>
    </message>
    <message>
        <source>: use a point as the decimal sign</source>
        <translation>: das Dezimalzeichen ist ein Punkt</translation>
    </message>
    <message>
        <source>%1 is not drawn because of an error: %2</source>
        <translation>%1: ein Fehler ist aufgetreten, die Ansicht wird nicht gezeichnet: %2</translation>
    </message>
    <message>
        <source>%1 had an error: %2</source>
        <translation>%1: ein Fehler ist aufgetreten: %2</translation>
    </message>
    <message>
        <source> (%1 times)</source>
        <translation> (%1-mal)</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>es ist nicht genug Speicher da</translation>
    </message>
    <message>
        <source>an exception without a message</source>
        <translation>eine Ausnahme ohne Worte</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>This view is not drawn because of an error: see Problems.</source>
        <translation>Diese Ansicht wird wegen eines Fehlers nicht gezeichnet: siehe Probleme.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Wieder zeigen</translation>
    </message>
    <message>
        <source>Inspector: values</source>
        <translation>Inspektor: Werte</translation>
    </message>
    <message>
        <source>Inspector: events</source>
        <translation>Inspektor: Ereignisse</translation>
    </message>
    <message>
        <source>Inspector: call</source>
        <translation>Inspektor: Aufruf</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>nicht gestartet</translation>
    </message>
    <message>
        <source>did not run</source>
        <translation>lief nicht</translation>
    </message>
    <message>
        <source> cannot be shown: </source>
        <translation> kann nicht gezeigt werden: </translation>
    </message>
    <message>
        <source>The component is notified that it was suspended. If its author has written code for this case, the component starts from the current situation; otherwise the component continues its previous action.</source>
        <translation>Der Komponente wird gesagt, dass sie angehalten war. Wenn ihr Autor das vorgesehen hat, beginnt sie mit der jetzigen Lage; sonst setzt sie ihre vorige Aktion fort.</translation>
    </message>
    <message>
        <source>The component starts from the beginning: no previous action continues.</source>
        <translation>Die Komponente beginnt von vorn: keine vorige Aktion geht weiter.</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>a state, a time</comment>
        <translation>%1 seit %2</translation>
    </message>
    <message>
        <source>%1 had an error: see Problems</source>
        <translation>%1: ein Fehler ist aufgetreten, siehe Probleme</translation>
    </message>
    <message>
        <source> waits for </source>
        <translation> wartet auf </translation>
    </message>
    <message>
        <source>Waits for</source>
        <translation>Wartet auf</translation>
    </message>
    <message>
        <source> runs </source>
        <translation> führt </translation>
    </message>
    <message>
        <source>the file is missing: restore the file before you restart the process</source>
        <translation>die Datei ist weg: vor einem neuen Start des Prozesses zurücklegen</translation>
    </message>
    <message>
        <source>the file was written again at %1: restart the process to use the new file</source>
        <translation>die Datei wurde um %1 neu geschrieben: für die neue Datei den Prozess neu starten</translation>
    </message>
    <message>
        <source>Plug-in</source>
        <translation>Plug-in</translation>
    </message>
    <message>
        <source>File has changed</source>
        <translation>Datei geändert</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a file, and when it was written</comment>
        <translation>%1 vom %2</translation>
    </message>
    <message>
        <source>the console</source>
        <translation>die Konsole</translation>
    </message>
    <message>
        <source>a picture for the clipboard</source>
        <translation>ein Bild für die Zwischenablage</translation>
    </message>
    <message>
        <source>the layout of the graph</source>
        <translation>die Anordnung des Graphen</translation>
    </message>
    <message>
        <source>the reading of a file</source>
        <translation>das Lesen einer Datei</translation>
    </message>
    <message>
        <source>a step of a plan</source>
        <translation>ein Schritt eines Plans</translation>
    </message>
    <message>
        <source>a system file</source>
        <translation>eine Systemdatei</translation>
    </message>
    <message>
        <source>the comparison with a system file</source>
        <translation>der Vergleich mit einer Systemdatei</translation>
    </message>
    <message>
        <source>The action ends unless the command is called again within %1</source>
        <translation>Die Aktion endet, wenn der Befehl nicht binnen %1 wieder aufgerufen wird</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 Kurven</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>Au&amp;fzeichnung</translation>
    </message>
    <message>
        <source>Alt+S, P, R, G, V, H</source>
        <translation>Alt+S, P, F, G, A, H</translation>
    </message>
    <message>
        <source>Records the plotted signals into a file  (Ctrl+R)</source>
        <translation>Zeichnet die geplotteten Signale in eine Datei auf  (Ctrl+R)</translation>
    </message>
    <message>
        <source>Records the selected component into a file  (Ctrl+R)</source>
        <translation>Zeichnet die gewählte Komponente in eine Datei auf  (Ctrl+R)</translation>
    </message>
    <message>
        <source>Records everything into a file  (Ctrl+R)</source>
        <translation>Zeichnet alles in eine Datei auf  (Ctrl+R)</translation>
    </message>
    <message>
        <source>What to record</source>
        <translation>Was aufgezeichnet wird</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufzeichnen</translation>
    </message>
    <message>
        <source>Stop the recording</source>
        <translation>Die Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Completes the file  (Ctrl+R)</source>
        <translation>Schließt die Datei ab  (Ctrl+R)</translation>
    </message>
    <message>
        <source>%1 plotted signal</source>
        <translation>%1 geplottetes Signal</translation>
    </message>
    <message>
        <source>%1 plotted signals</source>
        <translation>%1 geplottete Signale</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>alles</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>Nichts ist geplottet</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Nichts ist ausgewählt</translation>
    </message>
    <message>
        <source>Plot a signal (P), or select another subject in the menu Record.</source>
        <translation>Erst ein Signal plotten (P) oder im Menü Aufzeichnung etwas anderes wählen.</translation>
    </message>
    <message>
        <source>Select a component, or select another subject in the menu Record.</source>
        <translation>Erst eine Komponente auswählen oder im Menü Aufzeichnung etwas anderes wählen.</translation>
    </message>
    <message>
        <source>Nothing is recorded</source>
        <translation>Nichts wird aufgezeichnet</translation>
    </message>
    <message>
        <source>The recording continues: %1</source>
        <translation>Die Aufzeichnung läuft weiter: %1</translation>
    </message>
    <message>
        <source>The recording has stopped</source>
        <translation>Die Aufzeichnung ist abgebrochen</translation>
    </message>
    <message>
        <source>Recorded %1 rows in %2 (%3, %4 lost)</source>
        <translation>%1 Zeilen in %2 aufgezeichnet (%3, %4 verloren)</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Im Ordner zeigen</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Pfad kopieren</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Ordner wählen…</translation>
    </message>
    <message>
        <source>Close this line</source>
        <translation>Diese Zeile schließen</translation>
    </message>
    <message>
        <source>Growth of the file in the last five seconds</source>
        <translation>Wachstum der Datei in den letzten fünf Sekunden</translation>
    </message>
    <message>
        <source>Size of the file</source>
        <translation>Größe der Datei</translation>
    </message>
    <message>
        <source>Completing the file</source>
        <translation>Die Datei wird abgeschlossen</translation>
    </message>
    <message>
        <source>Starting to record</source>
        <translation>Die Aufzeichnung beginnt</translation>
    </message>
    <message>
        <source>Saving the last %1 s</source>
        <translation>Speichert die letzten %1 s</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Zeichnet auf</translation>
    </message>
    <message>
        <source>Was interrupted</source>
        <translation>War unterbrochen</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 Zeilen</translation>
    </message>
    <message>
        <source>%1 rows, %2 events, %3 commands, %4 records of the log</source>
        <translation>%1 Zeilen, %2 Ereignisse, %3 Befehle, %4 Einträge des Protokolls</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 frei</translation>
    </message>
    <message>
        <source>Free space on the disk of the file</source>
        <translation>Freier Platz auf dem Datenträger der Datei</translation>
    </message>
    <message>
        <source>Every row and event is in the file.</source>
        <translation>Alle Zeilen und Ereignisse sind in der Datei.</translation>
    </message>
    <message>
        <source>%1 in this window, because the disk was too slow</source>
        <translation>%1 in diesem Fenster, weil der Datenträger zu langsam war</translation>
    </message>
    <message>
        <source>%1: rows lost: %2</source>
        <translation>%1: Zeilen verloren: %2</translation>
    </message>
    <message>
        <source>%1: events lost: %2</source>
        <translation>%1: Ereignisse verloren: %2</translation>
    </message>
    <message>
        <source>Records of the log lost: %1</source>
        <translation>Einträge des Protokolls verloren: %1</translation>
    </message>
    <message>
        <source>The disk is almost full.</source>
        <translation>Der Datenträger ist fast voll.</translation>
    </message>
    <message>
        <source>At this rate, the disk is full in %1 (minutes and seconds).</source>
        <translation>So ist der Datenträger in %1 voll (Minuten und Sekunden).</translation>
    </message>
    <message>
        <source>the folder %1 cannot be created: %2</source>
        <translation>der Ordner %1 lässt sich nicht anlegen: %2</translation>
    </message>
    <message>
        <source>&amp;Start recording</source>
        <translation>Aufzeichnung &amp;starten</translation>
    </message>
    <message>
        <source>Save the &amp;last 30 s</source>
        <translation>Die &amp;letzten 30 s speichern</translation>
    </message>
    <message>
        <source>Nothing is saved</source>
        <translation>Nichts ist gespeichert</translation>
    </message>
    <message>
        <source>Saved the last %1 s: %2 rows, %3 events (%4)</source>
        <translation>Die letzten %1 s gespeichert: %2 Zeilen, %3 Ereignisse (%4)</translation>
    </message>
    <message>
        <source>Rows, events and log of the last seconds, which can be saved at any time: Record, Save the last 30 s</source>
        <translation>Zeilen, Ereignisse und Protokoll der letzten Sekunden, die jederzeit gespeichert werden können: Aufzeichnung, Die letzten 30 s speichern</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Verlauf</translation>
    </message>
    <message>
        <source>&amp;Folder for recordings…</source>
        <translation>&amp;Ordner für Aufzeichnungen…</translation>
    </message>
    <message>
        <source>What to record: &amp;plotted signals</source>
        <translation>Aufzeichnen: ge&amp;plottete Signale</translation>
    </message>
    <message>
        <source>What to record: selected &amp;component</source>
        <translation>Aufzeichnen: gewählte &amp;Komponente</translation>
    </message>
    <message>
        <source>What to record: &amp;everything</source>
        <translation>Aufzeichnen: &amp;alles</translation>
    </message>
    <message>
        <source>&amp;Stop recording</source>
        <translation>Aufzeichnung b&amp;eenden</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Ordner für Aufzeichnungen</translation>
    </message>
    <message>
        <source>Recordings go to %1</source>
        <translation>Aufzeichnungen kommen nach %1</translation>
    </message>
    <message>
        <source>No file manager could be started; the file is in %1</source>
        <translation>Kein Dateimanager ließ sich starten; die Datei ist in %1</translation>
    </message>
    <message>
        <source>The path is in the clipboard</source>
        <translation>Der Pfad ist in der Zwischenablage</translation>
    </message>
    <message>
        <source>Open a recor&amp;ding…</source>
        <translation>Eine Auf&amp;zeichnung öffnen…</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Eine Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Recordings (*.mcap)</source>
        <translation>Aufzeichnungen (*.mcap)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 cannot be opened, because %2 cannot be started</source>
        <translation>%1 kann nicht geöffnet werden, weil sich %2 nicht starten lässt</translation>
    </message>
    <message>
        <source>%1 opens in a separate window</source>
        <translation>%1 öffnet sich in einem eigenen Fenster</translation>
    </message>
    <message>
        <source>Open another recording…</source>
        <translation>Eine andere Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>%1 is being opened</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>A file without an index, such as a file that is still being written, must first be read completely.</source>
        <translation>Eine Datei ohne Verzeichnis, etwa eine, die noch geschrieben wird, wird zuerst ganz gelesen.</translation>
    </message>
    <message>
        <source>%1 cannot be shown</source>
        <translation>%1 kann nicht gezeigt werden</translation>
    </message>
    <message>
        <source>No component at this moment</source>
        <translation>Keine Komponente zu diesem Zeitpunkt</translation>
    </message>
    <message>
        <source>The recording has no component at this moment. Move the slider above, or look at the catalogue and the log.</source>
        <translation>Die Aufzeichnung hat zu diesem Zeitpunkt keine Komponente. Den Regler oben verschieben, oder Katalog und Protokoll ansehen.</translation>
    </message>
    <message>
        <source>the reading of a recording</source>
        <translation>das Lesen einer Aufzeichnung</translation>
    </message>
    <message>
        <source>This window shows the recording %1: nothing in it can be changed</source>
        <translation>Dieses Fenster zeigt die Aufzeichnung %1: nichts darin lässt sich ändern</translation>
    </message>
    <message>
        <source>this type is not in the recording</source>
        <translation>dieser Typ ist nicht in der Aufzeichnung</translation>
    </message>
    <message>
        <source>There is no event, loss or mark after this moment</source>
        <translation>Nach diesem Zeitpunkt gibt es kein Ereignis, keinen Verlust und keine Marke</translation>
    </message>
    <message>
        <source>There is no event, loss or mark before this moment</source>
        <translation>Vor diesem Zeitpunkt gibt es kein Ereignis, keinen Verlust und keine Marke</translation>
    </message>
    <message>
        <source>Previous event, loss or mark</source>
        <translation>Voriges Ereignis, voriger Verlust oder vorige Marke</translation>
    </message>
    <message>
        <source>One row or event back</source>
        <translation>Eine Zeile oder ein Ereignis zurück</translation>
    </message>
    <message>
        <source>One row or event forward</source>
        <translation>Eine Zeile oder ein Ereignis weiter</translation>
    </message>
    <message>
        <source>Next event, loss or mark</source>
        <translation>Nächstes Ereignis, nächster Verlust oder nächste Marke</translation>
    </message>
    <message>
        <source>The recording is being opened</source>
        <translation>Die Aufzeichnung wird geöffnet</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>Wie schnell die Aufzeichnung abgespielt wird</translation>
    </message>
    <message>
        <source>Restart at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
    </message>
    <message>
        <source>Mark this moment, or remove its mark</source>
        <translation>Diesen Zeitpunkt markieren oder seine Marke entfernen</translation>
    </message>
    <message>
        <source>Copy the command gcm recover</source>
        <translation>Den Befehl gcm recover kopieren</translation>
    </message>
    <message>
        <source>In the clipboard: %1</source>
        <translation>In der Zwischenablage: %1</translation>
    </message>
    <message>
        <source>Load newer data</source>
        <translation>Neues nachladen</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>is being opened…</source>
        <translation>wird geöffnet…</translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation>kann nicht gezeigt werden</translation>
    </message>
    <message>
        <source>recorded on %1 at %2</source>
        <translation>aufgezeichnet am %1 um %2</translation>
    </message>
    <message>
        <source>The file is still being written; it is shown up to %1</source>
        <translation>Die Datei wird noch geschrieben; gezeigt wird sie bis %1</translation>
    </message>
    <message>
        <source>The end of the file is missing or damaged; it is shown up to %1. To repair it: gcm recover</source>
        <translation>Das Ende der Datei fehlt oder ist beschädigt; gezeigt wird sie bis %1. Zum Reparieren: gcm recover</translation>
    </message>
    <message>
        <source>Parts of the file are damaged and are left out: %1. To repair it: gcm recover</source>
        <translation>Teile der Datei sind beschädigt und fehlen: %1. Zum Reparieren: gcm recover</translation>
    </message>
    <message>
        <source>Not complete</source>
        <translation>Unvollständig</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Beschädigt</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>WIEDERGABE</translation>
    </message>
    <message>
        <source>Moment of the recording</source>
        <translation>Zeitpunkt der Aufzeichnung</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>&amp;Wiedergabe</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>One row or event for&amp;ward</source>
        <translation>Eine Zeile oder ein Ereignis &amp;weiter</translation>
    </message>
    <message>
        <source>One row or event &amp;back</source>
        <translation>Eine Zeile oder ein Ereignis zurüc&amp;k</translation>
    </message>
    <message>
        <source>&amp;Next event, loss or mark</source>
        <translation>&amp;Nächstes Ereignis, nächster Verlust oder nächste Marke</translation>
    </message>
    <message>
        <source>P&amp;revious event, loss or mark</source>
        <translation>&amp;Voriges Ereignis, voriger Verlust oder vorige Marke</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>Zum An&amp;fang</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>Zum &amp;Ende</translation>
    </message>
    <message>
        <source>&amp;Mark this moment, or remove its mark</source>
        <translation>Diesen Zeitpunkt &amp;markieren oder seine Marke entfernen</translation>
    </message>
    <message>
        <source>Open a recording…</source>
        <translation>Eine Aufzeichnung öffnen…</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>REPLAY %1 – gcm-gui</source>
        <translation>WIEDERGABE %1 – gcm-gui</translation>
    </message>
    <message>
        <source>This window shows the recording %1. It is connected to no running system.</source>
        <translation>Dieses Fenster zeigt die Aufzeichnung %1. Es ist mit keinem laufenden System verbunden.</translation>
    </message>
    <message>
        <source>Add a curve of a recor&amp;ding…</source>
        <translation>Eine Kurve einer Aufzeichnung &amp;dazunehmen…</translation>
    </message>
    <message>
        <source>Ctrl+Left, Ctrl+Right, T</source>
        <translation>Strg+Links, Strg+Rechts, T</translation>
    </message>
    <message>
        <source>Shift a recorded curve in time; T sets an exact shift</source>
        <translation>Eine aufgezeichnete Kurve in der Zeit verschieben; auf einen genauen Wert</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>This time is added to all times of the recording: “-12.5” or “+2 h 03 min”</source>
        <translation>Wird zu allen Zeiten der Aufzeichnung addiert: „-12.5“ oder „+2 h 03 min“</translation>
    </message>
    <message>
        <source>Shift, scale, offset and axis…</source>
        <translation>Verschiebung, Faktor, Versatz und Achse…</translation>
    </message>
    <message>
        <source>Shift…</source>
        <translation>Verschieben…</translation>
    </message>
    <message>
        <source>Begin at the left edge</source>
        <translation>Beginn an den linken Rand</translation>
    </message>
    <message>
        <source>Remove its curves</source>
        <translation>Ihre Kurven entfernen</translation>
    </message>
    <message>
        <source>Add a curve of a recording…</source>
        <translation>Eine Kurve einer Aufzeichnung dazunehmen…</translation>
    </message>
    <message>
        <source>%1: &quot;recording&quot; must be a file, and &quot;shift_ns&quot; a whole number of ns up to 100 years</source>
        <translation>%1: &quot;recording&quot; muss eine Datei sein, und &quot;shift_ns&quot; eine ganze Zahl von ns bis 100 Jahre</translation>
    </message>
    <message>
        <source>%1 is shifted by %2; Alt+Left undoes the shift</source>
        <translation>%1 ist um %2 verschoben; Alt+Links nimmt es zurück</translation>
    </message>
    <message>
        <source>Recorded signals</source>
        <translation>Aufgezeichnete Signale</translation>
    </message>
    <message>
        <source>There is no such number in this recording.</source>
        <translation>In dieser Aufzeichnung gibt es keine solche Zahl.</translation>
    </message>
    <message>
        <source>The recording is being opened…</source>
        <translation>Die Aufzeichnung wird geöffnet…</translation>
    </message>
    <message>
        <source>Add to the plot</source>
        <translation>In den Plot nehmen</translation>
    </message>
    <message>
        <source>Add curves of %1</source>
        <translation>Kurven von %1 dazunehmen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Filter of the recorded signals</source>
        <translation>Filter der aufgezeichneten Signale</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Select one or more of %1 signals</source>
        <translation>Eines oder mehrere von %1 Signalen wählen</translation>
    </message>
    <message>
        <source>%1 of %2 selected</source>
        <translation>%1 von %2 gewählt</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>wird gelesen</translation>
    </message>
    <message>
        <source>the file does not exist any more; the data that was already read is still shown</source>
        <translation>die Datei ist nicht mehr da; was gelesen wurde, bleibt</translation>
    </message>
    <message>
        <source>%1 is damaged, and shown as far as it can be read: %2</source>
        <translation>%1 ist beschädigt und wird so weit gezeigt, wie es lesbar ist: %2</translation>
    </message>
    <message>
        <source>Add a curve of a recording</source>
        <translation>Eine Kurve einer Aufzeichnung dazunehmen</translation>
    </message>
    <message>
        <source>%1 is dashed: drag it in time with Ctrl, or press T to set its shift</source>
        <translation>%1 ist gestrichelt: mit Strg in der Zeit ziehen, oder mit T die Verschiebung angeben</translation>
    </message>
    <message>
        <source>The shift “%1” is no time, or over 100 years: write seconds, such as -12.5, or +2 h 03 min</source>
        <translation>Die Verschiebung „%1“ ist keine Zeit oder über 100 Jahre: Sekunden wie -12.5 schreiben, oder +2 h 03 min</translation>
    </message>
    <message>
        <source>nothing recorded at this time</source>
        <translation>zu dieser Zeit nichts aufgezeichnet</translation>
    </message>
</context>
</TS>
