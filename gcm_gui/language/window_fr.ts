<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr_FR">
<context>
    <name>Words</name>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>log level</source>
        <translation>niveau du journal</translation>
    </message>
    <message>
        <source> · %1 times</source>
        <translation> · %1 fois</translation>
    </message>
    <message>
        <source> · undone</source>
        <translation> · annulé</translation>
    </message>
    <message>
        <source>Your changes to the system are listed here.</source>
        <translation>Ce que vous faites au système est noté ici.</translation>
    </message>
    <message>
        <source>Nothing is wrong.</source>
        <translation>Tout va bien.</translation>
    </message>
    <message>
        <source>Activity</source>
        <translation>Activité</translation>
    </message>
    <message>
        <source>Problems</source>
        <translation>Problèmes</translation>
    </message>
    <message>
        <source>Log</source>
        <translation>Journal</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Événements</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Console</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Copy as command</source>
        <translation>Copier en commande</translation>
    </message>
    <message>
        <source>Problems %1</source>
        <translation>Problèmes %1</translation>
    </message>
    <message>
        <source> is lost</source>
        <translation> est perdu</translation>
    </message>
    <message>
        <source> does not answer; its values may be old</source>
        <translation> ne répond pas&#xa0;; ses valeurs peuvent être anciennes</translation>
    </message>
    <message>
        <source> is faulted</source>
        <translation> est en défaut</translation>
    </message>
    <message>
        <source> is not connected</source>
        <translation> n&apos;est pas connectée</translation>
    </message>
    <message>
        <source>…
For the whole result, use Copy as command</source>
        <translation>…
La réponse entière&#xa0;: Copier en commande</translation>
    </message>
    <message>
        <source>Call a command</source>
        <translation>Appeler une commande</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Réponse</translation>
    </message>
    <message>
        <source>Argument as JSON</source>
        <translation>Argument en JSON</translation>
    </message>
    <message>
        <source>Call</source>
        <translation>Appeler</translation>
    </message>
    <message>
        <source>Not called: this command can move something; hold the button for 0.4 s</source>
        <translation>Pas appelée&#xa0;: maintenir le bouton 0.4&#xa0;s, car cela peut mettre quelque chose en mouvement</translation>
    </message>
    <message>
        <source>Ask again</source>
        <translation>Redemander</translation>
    </message>
    <message>
        <source>Shows the argument as JSON text instead of a form</source>
        <translation>L&apos;argument en texte, au lieu d&apos;un formulaire</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copies the command line that does the same in a terminal</source>
        <translation>Copie la ligne qui fait la même chose dans un terminal</translation>
    </message>
    <message>
        <source>Add to the favourites</source>
        <translation>Ajouter aux favoris</translation>
    </message>
    <message>
        <source>Adds a button for this command and argument</source>
        <translation>Ajoute un bouton pour cette commande et cet argument</translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation>Répéter</translation>
    </message>
    <message>
        <source>Calls the command repeatedly</source>
        <translation>L&apos;appelle encore et encore</translation>
    </message>
    <message>
        <source>Call </source>
        <translation>Appeler </translation>
    </message>
    <message>
        <source>Loading the argument…</source>
        <translation>Demande de l&apos;argument attendu…</translation>
    </message>
    <message>
        <source>Hold to call</source>
        <translation>Maintenir pour appeler</translation>
    </message>
    <message>
        <source>This command can move something: hold the button for 0.4 s, or press Ctrl+Enter twice</source>
        <translation>Cela peut mettre quelque chose en mouvement&#xa0;: maintenir le bouton 0.4&#xa0;s ou appuyer deux fois sur Ctrl+Entrée</translation>
    </message>
    <message>
        <source>Ctrl+Enter</source>
        <translation>Ctrl+Entrée</translation>
    </message>
    <message>
        <source>This command can move something: press Ctrl+Enter again to call it</source>
        <translation>Encore Ctrl+Entrée pour appeler&#xa0;: cela peut mettre quelque chose en mouvement</translation>
    </message>
    <message>
        <source>Calling…</source>
        <translation>Appel en cours…</translation>
    </message>
    <message>
        <source>Done in </source>
        <translation>Terminé en </translation>
    </message>
    <message>
        <source>JSON of </source>
        <translation>JSON de </translation>
    </message>
    <message>
        <source>Favourites</source>
        <translation>Favoris</translation>
    </message>
    <message>
        <source>Favourite commands</source>
        <translation>Commandes favorites</translation>
    </message>
    <message>
        <source>Waiting for </source>
        <translation>En attente de </translation>
    </message>
    <message>
        <source>
This command can move something: hold the button for 0.4 s</source>
        <translation>
Cela peut mettre quelque chose en mouvement&#xa0;: maintenir le bouton 0.4&#xa0;s</translation>
    </message>
    <message>
        <source>Show the command</source>
        <translation>Montrer la commande</translation>
    </message>
    <message>
        <source>Remove from favourites</source>
        <translation>Retirer des favoris</translation>
    </message>
    <message>
        <source>Calls a second</source>
        <translation>Appels par seconde</translation>
    </message>
    <message>
        <source>How many calls</source>
        <translation>Nombre d&apos;appels</translation>
    </message>
    <message>
        <source>until stopped</source>
        <translation>jusqu&apos;à l&apos;arrêt</translation>
    </message>
    <message>
        <source> times</source>
        <translation> fois</translation>
    </message>
    <message>
        <source>%1 call</source>
        <translation>%1 appel</translation>
    </message>
    <message>
        <source>%1 calls</source>
        <translation>%1 appels</translation>
    </message>
    <message>
        <source>, %1 skipped: the previous call took too long</source>
        <translation>, %1 omis&#xa0;: le précédent a duré trop longtemps</translation>
    </message>
    <message>
        <source>Hold to repeat</source>
        <translation>Maintenir pour répéter</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>This command can move something: hold the button for 0.4 s; the calls repeat until you release the button</source>
        <translation>Cela peut mettre quelque chose en mouvement&#xa0;: les appels durent tant que le bouton est maintenu, à partir de 0.4&#xa0;s</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Candidats</translation>
    </message>
    <message>
        <source>No candidate matches the filter.</source>
        <translation>Aucun candidat ne répond au filtre.</translation>
    </message>
    <message>
        <source>Connect</source>
        <translation>Connecter</translation>
    </message>
    <message>
        <source>Candidates for a connection</source>
        <translation>Candidats à une connexion</translation>
    </message>
    <message>
        <source>Esc cancels</source>
        <translation>Esc pour annuler</translation>
    </message>
    <message>
        <source>Filter the candidates</source>
        <translation>Filtrer les candidats</translation>
    </message>
    <message>
        <source>Filter; Enter or 1 to 9 picks</source>
        <translation>Filtre&#xa0;; Entrée choisit, de même 1 à 9</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Remplacer</translation>
    </message>
    <message>
        <source>%1 is connected to %2. Other candidates:</source>
        <translation>%1 est connectée à %2. À quoi elle pourrait être connectée à la place&#xa0;:</translation>
    </message>
    <message>
        <source>Provided interfaces for %1:</source>
        <translation>À quoi %1 pourrait être connectée&#xa0;:</translation>
    </message>
    <message>
        <source>Required interfaces for %1:</source>
        <translation>Ce qui pourrait être connecté à %1&#xa0;:</translation>
    </message>
    <message>
        <source>
Has %1 of the %2 commands and events that are needed.</source>
        <translation>
Possède %1 des %2 commandes et événements requis.</translation>
    </message>
    <message>
        <source>replaces %1</source>
        <translation>remplace %1</translation>
    </message>
    <message>
        <source>%1 more: type a part of the name to find one</source>
        <translation>%1 autres&#xa0;; taper pour chercher</translation>
    </message>
    <message>
        <source>None of %1 fits</source>
        <translation>Aucun des %1 ne convient</translation>
    </message>
    <message>
        <source>%1 more do not fit</source>
        <translation>%1 autres ne conviennent pas du tout</translation>
    </message>
    <message>
        <source>is the current connection</source>
        <translation>est déjà la connexion actuelle</translation>
    </message>
    <message>
        <source> does not fit: </source>
        <translation> ne convient pas&#xa0;: </translation>
    </message>
    <message>
        <source>Match by name and type</source>
        <translation>Associer par nom et type</translation>
    </message>
    <message>
        <source>%1 of %2 required interfaces have a candidate. Space checks a row, Enter connects all checked rows.</source>
        <translation>%1 sur %2 interfaces requises ont un vis-à-vis. Espace coche, Entrée connecte ce qui est coché.</translation>
    </message>
    <message>
        <source>no available interface fits</source>
        <translation>rien de présent ne convient</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>une parmi %1</translation>
    </message>
    <message>
        <source>Connect %1</source>
        <translation>Connecter %1</translation>
    </message>
    <message>
        <source> interfaces</source>
        <translation> interfaces</translation>
    </message>
    <message>
        <source>Console output</source>
        <translation>Sortie de la console</translation>
    </message>
    <message>
        <source>Accepts the commands of gcm shell: try ls, watch, call … or help. Tab completes, Ctrl+C interrupts, Ctrl+R searches the history.</source>
        <translation>Le langage de gcm shell&#xa0;: essayer ls, watch, call … ou help. Tab complète, Ctrl+C interrompt, Ctrl+R cherche dans ce qui a été tapé.</translation>
    </message>
    <message>
        <source>Console line</source>
        <translation>Ligne de la console</translation>
    </message>
    <message>
        <source>search &apos;%1&apos;:</source>
        <translation>recherche «&#xa0;%1&#xa0;»&#xa0;:</translation>
    </message>
    <message>
        <source>nothing with &apos;%1&apos;:</source>
        <translation>rien avec «&#xa0;%1&#xa0;»&#xa0;:</translation>
    </message>
    <message>
        <source>… Ctrl+C</source>
        <translation>… Ctrl+C</translation>
    </message>
    <message>
        <source>%1 event</source>
        <translation>%1 événement</translation>
    </message>
    <message>
        <source>%1 events</source>
        <translation>%1 événements</translation>
    </message>
    <message>
        <source>no event</source>
        <translation>aucun événement</translation>
    </message>
    <message>
        <source> · %1 a second</source>
        <translation> · %1 par seconde</translation>
    </message>
    <message>
        <source> · %1 lost</source>
        <translation> · pertes&#xa0;: %1</translation>
    </message>
    <message>
        <source> · %1 waiting</source>
        <translation> · %1 en attente</translation>
    </message>
    <message>
        <source>No event has been raised since this page was opened.</source>
        <translation>Aucun événement depuis l&apos;ouverture de cette page.</translation>
    </message>
    <message>
        <source>Source of the listed events</source>
        <translation>De qui les événements sont listés</translation>
    </message>
    <message>
        <source>All components</source>
        <translation>Tous les composants</translation>
    </message>
    <message>
        <source>Selected component</source>
        <translation>Composant sélectionné</translation>
    </message>
    <message>
        <source>Filter the events</source>
        <translation>Filtrer les événements</translation>
    </message>
    <message>
        <source>Filter: words, from:robot/arm, -word</source>
        <translation>Filtre&#xa0;: mots, from:robot/arm, -mot</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The list is paused; new events are shown when the pause ends</source>
        <translation>La liste est figée&#xa0;; ce qui arrive est montré ensuite</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Vider</translation>
    </message>
    <message>
        <source>Select a component to see its events.</source>
        <translation>Sélectionner un composant pour voir ses événements.</translation>
    </message>
    <message>
        <source>the content cannot be encoded</source>
        <translation>encodage impossible</translation>
    </message>
    <message>
        <source>%1 was not saved: %2</source>
        <translation>%1 n&apos;a pas été enregistré&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 call was refused, because the mailbox was full</source>
        <translation>%1 appel a été refusé, car la boîte aux lettres était pleine</translation>
    </message>
    <message>
        <source>%1 calls were refused, because the mailbox was full</source>
        <translation>%1 appels ont été refusés, car la boîte aux lettres était pleine</translation>
    </message>
    <message>
        <source>%1 event was lost</source>
        <translation>%1 événement a été perdu</translation>
    </message>
    <message>
        <source>%1 events were lost</source>
        <translation>%1 événements ont été perdus</translation>
    </message>
    <message>
        <source>%1 of %2 calls wait</source>
        <translation>%1 appels sur %2 en attente</translation>
    </message>
    <message>
        <source>answers after </source>
        <translation>répond après </translation>
    </message>
    <message>
        <source>Save a picture of the graph</source>
        <translation>Enregistrer une image du graphe</translation>
    </message>
    <message>
        <source>SVG, scalable (*.svg)</source>
        <translation>SVG, aussi grand que voulu (*.svg)</translation>
    </message>
    <message>
        <source>PNG, as on the screen (*.png)</source>
        <translation>PNG, tel qu&apos;affiché (*.png)</translation>
    </message>
    <message>
        <source>DOT, for Graphviz (*.dot)</source>
        <translation>DOT, pour Graphviz (*.dot)</translation>
    </message>
    <message>
        <source>end the file name with .svg, .png or .dot to choose the format</source>
        <translation>terminer le nom du fichier par .svg, .png ou .dot pour choisir le format</translation>
    </message>
    <message>
        <source> saved</source>
        <translation> enregistré</translation>
    </message>
    <message>
        <source>The picture of the graph is in the clipboard</source>
        <translation>L&apos;image du graphe est dans le presse-papiers</translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation>et %1 autres</translation>
    </message>
    <message>
        <source> does not fit</source>
        <translation> ne convient pas</translation>
    </message>
    <message>
        <source>connecting …</source>
        <translation>connexion …</translation>
    </message>
    <message>
        <source>System graph</source>
        <translation>Graphe du système</translation>
    </message>
    <message>
        <source>was </source>
        <translation>était </translation>
    </message>
    <message>
        <source>no components</source>
        <translation>aucun composant</translation>
    </message>
    <message>
        <source>Map of the graph</source>
        <translation>Carte du graphe</translation>
    </message>
    <message>
        <source>The frame shows the visible part; to move it, press Shift and an arrow key in the graph</source>
        <translation>Le cadre est la partie visible&#xa0;; Maj et les flèches dans le graphe le déplacent</translation>
    </message>
    <message>
        <source>Drag the frame to see another part  (M hides the map)</source>
        <translation>Glisser le cadre pour voir une autre partie  (M masque la carte)</translation>
    </message>
    <message>
        <source>Find in the graph</source>
        <translation>Chercher dans le graphe</translation>
    </message>
    <message>
        <source>Component or interface</source>
        <translation>Composant ou interface</translation>
    </message>
    <message>
        <source>Previous match  (Shift+Enter)</source>
        <translation>Le précédent  (Maj+Entrée)</translation>
    </message>
    <message>
        <source>Next match  (Enter)</source>
        <translation>Le suivant  (Entrée)</translation>
    </message>
    <message>
        <source>End the search  (Esc)</source>
        <translation>Terminer la recherche  (Esc)</translation>
    </message>
    <message>
        <source>no match</source>
        <translation>aucun résultat</translation>
    </message>
    <message>
        <source>%1 found</source>
        <translation>trouvés&#xa0;: %1</translation>
    </message>
    <message>
        <source>No event has been raised since this list was opened.</source>
        <translation>Aucun événement depuis l&apos;ouverture.</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>pertes&#xa0;: %1</translation>
    </message>
    <message>
        <source>Processor</source>
        <translation>Processeur</translation>
    </message>
    <message>
        <source>Share of one core in the last second</source>
        <translation>D&apos;un cœur, dans la dernière seconde</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Mémoire</translation>
    </message>
    <message>
        <source>Resident</source>
        <translation>Résidente</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>Difference from the clock of the GCM, with its uncertainty; above 0 if the clock of the process is ahead</source>
        <translation>Écart avec l&apos;horloge du GCM, et son incertitude ; au-dessus de 0, l&apos;horloge avance</translation>
    </message>
    <message>
        <source>The fullest mailbox of the component holds %1 of at most %2 messages</source>
        <translation>%1 sur %2 en attente dans la boîte aux lettres la plus pleine du composant</translation>
    </message>
    <message>
        <source>no reply</source>
        <translation>sans réponse</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>Période</translation>
    </message>
    <message>
        <source> · now </source>
        <translation> · maintenant </translation>
    </message>
    <message>
        <source>Planned rate, and actual rate in the last second</source>
        <translation>À quelle cadence il doit tourner, et à laquelle il a tourné dans la dernière seconde</translation>
    </message>
    <message>
        <source>Starts late by</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>%1 · max %2</source>
        <translation>%1 · max %2</translation>
    </message>
    <message>
        <source>Delay of the cycles of the last second: at most %1 for half of them, %2 for 99 of 100, %3 for all</source>
        <translation>Dans la dernière seconde, la moitié des cycles a commencé au plus %1 après l&apos;échéance, 99 sur 100 au plus %2, tous au plus %3</translation>
    </message>
    <message>
        <source>Skipped cycles</source>
        <translation>Cycles sautés</translation>
    </message>
    <message>
        <source>Since the task was started; a cycle is skipped if an earlier one took too long</source>
        <translation>Depuis le démarrage ; un cycle est sauté si un précédent a duré trop longtemps</translation>
    </message>
    <message>
        <source>Busy</source>
        <translation>Occupation</translation>
    </message>
    <message>
        <source>Share of the period that is used for computation, mean of the last second</source>
        <translation>Part de sa période passée à calculer, moyenne de la dernière seconde</translation>
    </message>
    <message>
        <source>Inspector</source>
        <translation>Inspecteur</translation>
    </message>
    <message>
        <source>Forget this process</source>
        <translation>Oublier ce processus</translation>
    </message>
    <message>
        <source>Removes the process and its last state from the catalogue</source>
        <translation>Retire du catalogue le processus et son dernier état</translation>
    </message>
    <message>
        <source>Interfaces</source>
        <translation>Interfaces</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Valeurs</translation>
    </message>
    <message>
        <source>Config</source>
        <translation>Configuration</translation>
    </message>
    <message>
        <source>This component has no interfaces.</source>
        <translation>Ce composant n&apos;a pas d&apos;interfaces.</translation>
    </message>
    <message>
        <source>This component has no state table.</source>
        <translation>Ce composant n&apos;a pas de table d&apos;état.</translation>
    </message>
    <message>
        <source>Why?</source>
        <translation>Pourquoi&#xa0;?</translation>
    </message>
    <message>
        <source>Why is </source>
        <translation>Pourquoi </translation>
    </message>
    <message>
        <source>Disconnect</source>
        <translation>Déconnecter</translation>
    </message>
    <message>
        <source>Select a component in the catalogue or in the graph to see what it offers and needs.</source>
        <translation>Sélectionner un composant dans le catalogue ou le graphe pour voir ce qu&apos;il fournit et requiert.</translation>
    </message>
    <message>
        <source> is not available.</source>
        <translation> n&apos;est pas là.</translation>
    </message>
    <message>
        <source> since</source>
        <translation> depuis</translation>
    </message>
    <message>
        <source>Host</source>
        <translation>Machine</translation>
    </message>
    <message>
        <source>Process id</source>
        <translation>ID du processus</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>Composants</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Raison</translation>
    </message>
    <message>
        <source> does not answer</source>
        <translation> ne répond pas</translation>
    </message>
    <message>
        <source>Class</source>
        <translation>Classe</translation>
    </message>
    <message>
        <source>Fault</source>
        <translation>Défaut</translation>
    </message>
    <message>
        <source>Process</source>
        <translation>Processus</translation>
    </message>
    <message>
        <source>%1 client</source>
        <translation>%1 client</translation>
    </message>
    <message>
        <source>%1 clients</source>
        <translation>%1 clients</translation>
    </message>
    <message>
        <source>The log of all processes is listed here.</source>
        <translation>Ce que journalisent les processus est listé ici.</translation>
    </message>
    <message>
        <source>No record matches the filter.</source>
        <translation>Aucune entrée ne correspond au filtre.</translation>
    </message>
    <message>
        <source>Recorded system</source>
        <translation>Système enregistré</translation>
    </message>
    <message>
        <source>Lowest level that is shown</source>
        <translation>Plus bas niveau affiché</translation>
    </message>
    <message>
        <source>All levels</source>
        <translation>Tous les niveaux</translation>
    </message>
    <message>
        <source>Info and above</source>
        <translation>Info et au-dessus</translation>
    </message>
    <message>
        <source>Warnings and errors</source>
        <translation>Avertissements et erreurs</translation>
    </message>
    <message>
        <source>Errors</source>
        <translation>Erreurs</translation>
    </message>
    <message>
        <source>Filter the log</source>
        <translation>Filtrer le journal</translation>
    </message>
    <message>
        <source>Set level…</source>
        <translation>Régler le niveau…</translation>
    </message>
    <message>
        <source>Sets the lowest level that a process logs; this lasts until the process ends</source>
        <translation>Fixe le niveau le plus bas qu&apos;un processus journalise, jusqu&apos;à la fin de ce processus</translation>
    </message>
    <message>
        <source>Clears this list; the processes and the GCM keep their records</source>
        <translation>Vide cette liste ; les processus et le GCM gardent leurs enregistrements</translation>
    </message>
    <message>
        <source> and above</source>
        <translation> et au-dessus</translation>
    </message>
    <message>
        <source>There is no process</source>
        <translation>Il n&apos;y a aucun processus</translation>
    </message>
    <message>
        <source>%1 record</source>
        <translation>%1 entrée</translation>
    </message>
    <message>
        <source>%1 records</source>
        <translation>%1 entrées</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Required</source>
        <translation>Requise</translation>
    </message>
    <message>
        <source>Provided</source>
        <translation>Fournie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>État</translation>
    </message>
    <message>
        <source>%1 from %2, %3</source>
        <translation>%1 de %2, %3</translation>
    </message>
    <message>
        <source>Picture, </source>
        <translation>Image, </translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1 canaux</translation>
    </message>
    <message>
        <source>a picture with encoding &apos;%1&apos; cannot be drawn; supported encodings: %2</source>
        <translation>une image d&apos;encodage « %1 » ne peut pas être dessinée ; encodages possibles : %2</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is empty: width and height must be above 0</source>
        <translation>une image de %1 pixels est vide : la largeur et la hauteur doivent être supérieures à 0</translation>
    </message>
    <message>
        <source>a picture of %1 pixels is too large to be drawn: at most %2</source>
        <translation>une image de %1 pixels est trop grande pour être dessinée&#xa0;: au plus %2</translation>
    </message>
    <message>
        <source>a row of %1 pixels in %2 needs %3 bytes, but the field step is %4</source>
        <translation>une ligne de %1 pixels en %2 demande %3 octets, mais le champ step vaut %4</translation>
    </message>
    <message>
        <source>%1 rows of %2 bytes do not match the %3 bytes of data</source>
        <translation>%1 lignes de %2 octets ne correspondent pas à des données de %3 octets</translation>
    </message>
    <message>
        <source> lost</source>
        <translation> perdu</translation>
    </message>
    <message>
        <source>none lost</source>
        <translation>aucune perdue</translation>
    </message>
    <message>
        <source>%1 lost rows are marked</source>
        <translation>%1 perdues marquées</translation>
    </message>
    <message>
        <source>Saved %1 row, %2, to %3</source>
        <translation>%1 ligne, %2, enregistrée dans %3</translation>
    </message>
    <message>
        <source>Saved %1 rows, %2, to %3</source>
        <translation>%1 lignes, %2, enregistrées dans %3</translation>
    </message>
    <message>
        <source>%1 of %2 MB for samples</source>
        <translation>%1 sur %2 Mo pour les échantillons</translation>
    </message>
    <message>
        <source>; of older samples, only the lowest and highest value of each 100 ms are kept</source>
        <translation>, les plus anciens étant gardés comme plus petite et plus grande valeur par 100&#xa0;ms</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Légende</translation>
    </message>
    <message>
        <source>min%1  max%2  mean%3  σ%4  rms%5  p-p%6  %7</source>
        <translation>min%1  max%2  moy%3  σ%4  rms%5  p-p%6  %7</translation>
    </message>
    <message>
        <source>Close this plot</source>
        <translation>Fermer ce graphique</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
    <message>
        <source>New plot</source>
        <translation>Nouveau graphique</translation>
    </message>
    <message>
        <source>Add a plot below with the same time axis  (Ctrl+Shift+T)</source>
        <translation>Graphique en dessous, avec le même temps  (Ctrl+Maj+T)</translation>
    </message>
    <message>
        <source>Time span of the plot</source>
        <translation>Durée que montre le graphique</translation>
    </message>
    <message>
        <source>Back to the previous view  (Alt+Left)</source>
        <translation>Revenir à la vue précédente  (Alt+Gauche)</translation>
    </message>
    <message>
        <source>Forward again  (Alt+Right)</source>
        <translation>Avancer de nouveau  (Alt+Droite)</translation>
    </message>
    <message>
        <source>Cursors A and B  (A, B; Delete)</source>
        <translation>Curseurs A et B  (A, B&#xa0;; Suppr)</translation>
    </message>
    <message>
        <source>Save the visible samples as CSV  (Ctrl+E)</source>
        <translation>Enregistrer la partie visible en CSV  (Ctrl+E)</translation>
    </message>
    <message>
        <source>Sweep: new samples overwrite the old curves from left to right  (S)</source>
        <translation>Balayage&#xa0;: les courbes restent en place et sont réécrites à partir de la gauche  (S)</translation>
    </message>
    <message>
        <source>Pause the view</source>
        <translation>Figer la vue</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Last </source>
        <translation>Dernières </translation>
    </message>
    <message>
        <source>Time span of the plot: </source>
        <translation>Durée que montre le graphique&#xa0;: </translation>
    </message>
    <message>
        <source>Resume the view</source>
        <translation>Reprendre la vue</translation>
    </message>
    <message>
        <source>Resume the view (Space)</source>
        <translation>Reprendre la vue (Espace)</translation>
    </message>
    <message>
        <source>Pause the view; new data is still received (Space)</source>
        <translation>Figer la vue, pas les données (Espace)</translation>
    </message>
    <message>
        <source>Fit the visible part</source>
        <translation>Ajuster au visible</translation>
    </message>
    <message>
        <source>Only grow</source>
        <translation>Seulement agrandir</translation>
    </message>
    <message>
        <source>Symmetric around 0</source>
        <translation>Symétrique autour de 0</translation>
    </message>
    <message>
        <source>Logarithmic</source>
        <translation>Logarithmique</translation>
    </message>
    <message>
        <source>Statistics</source>
        <translation>Statistiques</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marques</translation>
    </message>
    <message>
        <source>Sweep</source>
        <translation>Balayage</translation>
    </message>
    <message>
        <source>Follow live data</source>
        <translation>Suivre le direct</translation>
    </message>
    <message>
        <source>Back to the previous view</source>
        <translation>Revenir à la vue précédente</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>Avancer de nouveau</translation>
    </message>
    <message>
        <source>A plot below</source>
        <translation>Graphique en dessous</translation>
    </message>
    <message>
        <source>Copy picture</source>
        <translation>Copier l&apos;image</translation>
    </message>
    <message>
        <source>Save picture…</source>
        <translation>Enregistrer l&apos;image…</translation>
    </message>
    <message>
        <source>Save the visible samples as CSV…</source>
        <translation>Enregistrer la partie visible en CSV…</translation>
    </message>
    <message>
        <source>Open layout…</source>
        <translation>Ouvrir une disposition…</translation>
    </message>
    <message>
        <source>Save layout of all plots…</source>
        <translation>Enregistrer la disposition de tous les graphiques…</translation>
    </message>
    <message>
        <source>There is nothing to save as CSV: the plot shows no samples</source>
        <translation>Rien à enregistrer en CSV&#xa0;: le graphique ne montre aucun échantillon</translation>
    </message>
    <message>
        <source>Save the visible samples as CSV</source>
        <translation>Enregistrer la partie visible en CSV</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>Save a picture of the plot</source>
        <translation>Enregistrer une image du graphique</translation>
    </message>
    <message>
        <source>PNG (*.png);;SVG (*.svg)</source>
        <translation>PNG (*.png);;SVG (*.svg)</translation>
    </message>
    <message>
        <source>Save the layout of all plots</source>
        <translation>Enregistrer la disposition de tous les graphiques</translation>
    </message>
    <message>
        <source>Plot layout (*.plots.json)</source>
        <translation>Disposition de graphiques (*.plots.json)</translation>
    </message>
    <message>
        <source>Open a layout of plots</source>
        <translation>Ouvrir une disposition de graphiques</translation>
    </message>
    <message>
        <source>Plot layout (*.plots.json *.json)</source>
        <translation>Disposition de graphiques (*.plots.json *.json)</translation>
    </message>
    <message>
        <source> cannot be read: </source>
        <translation> ne peut pas être lu&#xa0;: </translation>
    </message>
    <message>
        <source> is not a layout of plots: </source>
        <translation> n&apos;est pas une disposition de graphiques&#xa0;: </translation>
    </message>
    <message>
        <source>Show another signal</source>
        <translation>Montrer un autre signal</translation>
    </message>
    <message>
        <source>In place of </source>
        <translation>À la place de </translation>
    </message>
    <message>
        <source>Close plots</source>
        <translation>Fermer les graphiques</translation>
    </message>
    <message>
        <source>Close plot</source>
        <translation>Fermer le graphique</translation>
    </message>
    <message>
        <source>Plot %1</source>
        <translation>Graphique %1</translation>
    </message>
    <message>
        <source>Plot </source>
        <translation>Graphique </translation>
    </message>
    <message>
        <source>Select a value and press P, or drag it here</source>
        <translation>Sélectionner une valeur et appuyer sur P, ou la glisser ici</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Graphique</translation>
    </message>
    <message>
        <source>Plot canvas</source>
        <translation>Surface du graphique</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Direct</translation>
    </message>
    <message>
        <source>Fit the values again</source>
        <translation>Ajuster de nouveau aux valeurs</translation>
    </message>
    <message>
        <source>Follow live data again</source>
        <translation>Suivre de nouveau le direct</translation>
    </message>
    <message>
        <source> (double click)</source>
        <translation> (double clic)</translation>
    </message>
    <message>
        <source>far outside of this axis: </source>
        <translation>bien au-delà de cet axe : </translation>
    </message>
    <message>
        <source>values of 0 and below cannot be shown on this axis: </source>
        <translation>les valeurs de 0 et moins ne peuvent pas être montrées sur cet axe : </translation>
    </message>
    <message>
        <source> · %1 repeated</source>
        <translation> · %1 en double</translation>
    </message>
    <message>
        <source> · %1 silent</source>
        <translation> · %1 sans signal</translation>
    </message>
    <message>
        <source>Rate and lost rows: </source>
        <translation>Cadence et lignes perdues&#xa0;: </translation>
    </message>
    <message>
        <source>%1: %2, %3 row lost, %4 repeated</source>
        <translation>%1&#xa0;: %2, %3 ligne perdue, %4 en double</translation>
    </message>
    <message>
        <source>%1: %2, %3 rows lost, %4 repeated</source>
        <translation>%1&#xa0;: %2, %3 lignes perdues, %4 en double</translation>
    </message>
    <message>
        <source>waiting for </source>
        <translation>attend </translation>
    </message>
    <message>
        <source>connected for </source>
        <translation>établie depuis </translation>
    </message>
    <message>
        <source>round trip </source>
        <translation>aller-retour </translation>
    </message>
    <message>
        <source>%1 calls and events</source>
        <translation>%1 appels et événements</translation>
    </message>
    <message>
        <source>mailbox: %1 of %2 used</source>
        <translation>boîte aux lettres : %1 sur %2 occupés</translation>
    </message>
    <message>
        <source>%1 refused, %2 replaced, %3 events lost</source>
        <translation>%1 refusés, %2 remplacés, %3 événements perdus</translation>
    </message>
    <message>
        <source>%1 bytes: </source>
        <translation>%1 octets&#xa0;: </translation>
    </message>
    <message>
        <source>missing</source>
        <translation>manquant</translation>
    </message>
    <message>
        <source>only running</source>
        <translation>seulement actif</translation>
    </message>
    <message>
        <source>changed</source>
        <translation>modifié</translation>
    </message>
    <message>
        <source>stops or removes something that works</source>
        <translation>arrête ou retire quelque chose qui tourne</translation>
    </message>
    <message>
        <source>= %1   + %2 only running   − %3 missing   ~ %4 changed</source>
        <translation>= %1   + %2 seulement actifs   − %3 manquants   ~ %4 modifiés</translation>
    </message>
    <message>
        <source>not possible</source>
        <translation>impossible</translation>
    </message>
    <message>
        <source>The running system and its file</source>
        <translation>Ce qui tourne à côté de son fichier</translation>
    </message>
    <message>
        <source>Differences between the running system and its file</source>
        <translation>Différences entre ce qui tourne et son fichier</translation>
    </message>
    <message>
        <source>Apply →</source>
        <translation>Appliquer →</translation>
    </message>
    <message>
        <source>Change the running system to match this line of the file</source>
        <translation>Ce qui tourne devient comme cette ligne du fichier</translation>
    </message>
    <message>
        <source>← Update file</source>
        <translation>← Adapter le fichier</translation>
    </message>
    <message>
        <source>Change this line of the file to match the running system</source>
        <translation>Cette ligne du fichier devient comme ce qui tourne</translation>
    </message>
    <message>
        <source>Restore all…</source>
        <translation>Tout restaurer…</translation>
    </message>
    <message>
        <source>Steps of the plan</source>
        <translation>Étapes du plan</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Continue after an error</source>
        <translation>Continuer après une erreur</translation>
    </message>
    <message>
        <source>Undo restore</source>
        <translation>Annuler l&apos;opération</translation>
    </message>
    <message>
        <source>Carry out</source>
        <translation>Exécuter</translation>
    </message>
    <message>
        <source>%1: as in the file</source>
        <translation>%1 : comme dans le fichier</translation>
    </message>
    <message>
        <source>No system file is open.</source>
        <translation>Aucun fichier de système n&apos;est ouvert.</translation>
    </message>
    <message>
        <source>The running system matches the file.</source>
        <translation>Ce qui tourne correspond au fichier.</translation>
    </message>
    <message>
        <source>Ctrl+S saves the running system; Ctrl+O opens a saved system.</source>
        <translation>Ctrl+S enregistre ce qui tourne&#xa0;; Ctrl+O ouvre ce qui a été enregistré.</translation>
    </message>
    <message>
        <source>there is nothing to do</source>
        <translation>rien à faire</translation>
    </message>
    <message>
        <source>%1 step</source>
        <translation>%1 étape</translation>
    </message>
    <message>
        <source>%1 steps</source>
        <translation>%1 étapes</translation>
    </message>
    <message>
        <source>everything changes</source>
        <translation>tout change</translation>
    </message>
    <message>
        <source>will not touch </source>
        <translation>ne touchera pas à </translation>
    </message>
    <message>
        <source>%1 item</source>
        <translation>%1 élément</translation>
    </message>
    <message>
        <source>%1 items</source>
        <translation>%1 éléments</translation>
    </message>
    <message>
        <source>Target %1: step %2 of %3</source>
        <translation>Cible %1&#xa0;: étape %2 sur %3</translation>
    </message>
    <message>
        <source>Target %1: %2 done, %3 failed, %4 remaining</source>
        <translation>Cible %1&#xa0;: %2 faites, %3 échouées, %4 restantes</translation>
    </message>
    <message>
        <source>the previous state</source>
        <translation>l&apos;état d&apos;avant</translation>
    </message>
    <message>
        <source>%1, modified since %2</source>
        <translation>%1, modifié depuis %2</translation>
    </message>
    <message>
        <source>Saved to </source>
        <translation>Enregistré dans </translation>
    </message>
    <message>
        <source>Updated </source>
        <translation>Adapté&#xa0;: </translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>Visite</translation>
    </message>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Tour, %1: %2</source>
        <translation>Visite, %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Catalogue</source>
        <translation>Catalogue</translation>
    </message>
    <message>
        <source>Filter the catalogue</source>
        <translation>Filtrer le catalogue</translation>
    </message>
    <message>
        <source>Filter: arm type:read state:active</source>
        <translation>Filtre&#xa0;: arm type:read state:active</translation>
    </message>
    <message>
        <source>All words must be in the path; also -word, type:, state:, proc:, host:, /regex/  (Ctrl+F)</source>
        <translation>Tous les mots doivent être dans le chemin&#xa0;; aussi -mot, type:, state:, proc:, host:, /regex/  (Ctrl+F)</translation>
    </message>
    <message>
        <source>Nothing here yet.</source>
        <translation>Rien ici pour l&apos;instant.</translation>
    </message>
    <message>
        <source>No row matches the filter.</source>
        <translation>Aucune ligne ne répond au filtre.</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close  (Esc)</source>
        <translation>Fermer  (Esc)</translation>
    </message>
    <message>
        <source>other type</source>
        <translation>autre type</translation>
    </message>
    <message>
        <source>other kind</source>
        <translation>autre genre</translation>
    </message>
    <message>
        <source>Needed</source>
        <translation>Requis</translation>
    </message>
    <message>
        <source>Offered</source>
        <translation>Fourni</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Différence</translation>
    </message>
    <message>
        <source>, optional</source>
        <translation>, optionnel</translation>
    </message>
    <message>
        <source>good</source>
        <translation>réussie</translation>
    </message>
    <message>
        <source>bad</source>
        <translation>échouée</translation>
    </message>
    <message>
        <source>not reached</source>
        <translation>non atteint</translation>
    </message>
    <message>
        <source>Neither interface has a member.</source>
        <translation>Aucun côté n&apos;a de commande ni d&apos;événement.</translation>
    </message>
    <message>
        <source>The needed and the offered members, side by side</source>
        <translation>Ce qui est requis et ce qui est fourni, côte à côte</translation>
    </message>
    <message>
        <source>Step %1, %2: %3</source>
        <translation>Étape %1, %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Show side by side</source>
        <translation>Montrer côte à côte</translation>
    </message>
    <message>
        <source>fix: </source>
        <translation>remède&#xa0;: </translation>
    </message>
    <message>
        <source>Copy the fix: </source>
        <translation>Copier le remède&#xa0;: </translation>
    </message>
    <message>
        <source>Copied: </source>
        <translation>Copié&#xa0;: </translation>
    </message>
    <message>
        <source>Hide the comparison</source>
        <translation>Masquer la comparaison</translation>
    </message>
    <message>
        <source>Select a required interface to see why it is connected or not</source>
        <translation>Sélectionner une interface requise pour voir pourquoi elle est connectée ou non</translation>
    </message>
    <message>
        <source> is not connected, and no available interface resembles it</source>
        <translation> n&apos;est pas connectée, et rien de présent ne lui ressemble</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Réessayer</translation>
    </message>
    <message>
        <source>Copy report</source>
        <translation>Copier le rapport</translation>
    </message>
    <message>
        <source>Copy the report</source>
        <translation>Copier le rapport</translation>
    </message>
    <message>
        <source>Why? </source>
        <translation>Pourquoi&#xa0;? </translation>
    </message>
    <message>
        <source>checking …</source>
        <translation>vérification …</translation>
    </message>
    <message>
        <source>Try the connection again</source>
        <translation>Réessayer la connexion</translation>
    </message>
    <message>
        <source>Connect the two interfaces</source>
        <translation>Les connecter</translation>
    </message>
    <message>
        <source>The report is in the clipboard</source>
        <translation>Le rapport est dans le presse-papiers</translation>
    </message>
    <message>
        <source>fails at step %1 of %2</source>
        <translation>échoue à l&apos;étape %1 sur %2</translation>
    </message>
    <message>
        <source>connected and working</source>
        <translation>connectée et en service</translation>
    </message>
    <message>
        <source>nothing prevents the connection</source>
        <translation>rien n&apos;empêche de la connecter</translation>
    </message>
    <message>
        <source>refused at %1: %2</source>
        <translation>refusée à %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>         fix: </source>
        <translation>         remède&#xa0;: </translation>
    </message>
    <message>
        <source>  the same in a terminal: </source>
        <translation>  la même chose dans un terminal&#xa0;: </translation>
    </message>
    <message>
        <source>Values and plots continue, because they come directly from the processes.</source>
        <translation>Les valeurs et les graphiques viennent directement de leurs processus et continuent.</translation>
    </message>
    <message>
        <source>Grey parts show the state of %1 ago</source>
        <translation>Ce qui est gris date d&apos;il y a %1</translation>
    </message>
    <message>
        <source>Connected in %1 · Ctrl+Z undoes</source>
        <translation>Connexion faite en %1 · Ctrl+Z annule</translation>
    </message>
    <message>
        <source>Disconnected in %1 · Ctrl+Z undoes</source>
        <translation>Déconnexion faite en %1 · Ctrl+Z annule</translation>
    </message>
    <message>
        <source>Replaced in %1 · Ctrl+Z undoes</source>
        <translation>Remplacement fait en %1 · Ctrl+Z annule</translation>
    </message>
    <message>
        <source>Undone in %1</source>
        <translation>Annulation faite en %1</translation>
    </message>
    <message>
        <source>Forgotten</source>
        <translation>Oublié</translation>
    </message>
    <message>
        <source>Called in %1</source>
        <translation>Appel fait en %1</translation>
    </message>
    <message>
        <source>%1 logs %2 and above</source>
        <translation>%1 journalise %2 et au-dessus</translation>
    </message>
    <message>
        <source>Replace </source>
        <translation>Remplacer </translation>
    </message>
    <message>
        <source>Connect </source>
        <translation>Connecter </translation>
    </message>
    <message>
        <source> · no other provided interface fits · D disconnects · Esc cancels</source>
        <translation> · aucune autre interface fournie ne convient · D déconnecte · Esc annule</translation>
    </message>
    <message>
        <source> · no other required interface fits · D disconnects · Esc cancels</source>
        <translation> · aucune autre interface requise ne convient · D déconnecte · Esc annule</translation>
    </message>
    <message>
        <source> · pick another provided interface · D disconnects · Esc cancels</source>
        <translation> · choisir une autre interface fournie · D déconnecte · Esc annule</translation>
    </message>
    <message>
        <source> · pick another required interface · D disconnects · Esc cancels</source>
        <translation> · choisir une autre interface requise · D déconnecte · Esc annule</translation>
    </message>
    <message>
        <source> · no provided interface fits · Esc cancels</source>
        <translation> · aucune interface fournie ne convient · Esc annule</translation>
    </message>
    <message>
        <source> · no required interface fits · Esc cancels</source>
        <translation> · aucune interface requise ne convient · Esc annule</translation>
    </message>
    <message>
        <source> · pick a provided interface · Esc cancels</source>
        <translation> · choisir une interface fournie · Esc annule</translation>
    </message>
    <message>
        <source> · pick a required interface · Esc cancels</source>
        <translation> · choisir une interface requise · Esc annule</translation>
    </message>
    <message>
        <source>%1 process</source>
        <translation>%1 processus</translation>
    </message>
    <message>
        <source>%1 processes</source>
        <translation>%1 processus</translation>
    </message>
    <message>
        <source>%1 component</source>
        <translation>%1 composant</translation>
    </message>
    <message>
        <source>%1 components</source>
        <translation>%1 composants</translation>
    </message>
    <message>
        <source>%1 connection</source>
        <translation>%1 connexion</translation>
    </message>
    <message>
        <source>%1 connections</source>
        <translation>%1 connexions</translation>
    </message>
    <message>
        <source>Search or run   Ctrl+K</source>
        <translation>Chercher ou exécuter   Ctrl+K</translation>
    </message>
    <message>
        <source>Pause view</source>
        <translation>Figer la vue</translation>
    </message>
    <message>
        <source>Finds all commands and all objects  (Ctrl+K)</source>
        <translation>Trouve tout ce qui peut se faire et tout ce qui existe  (Ctrl+K)</translation>
    </message>
    <message>
        <source>Pauses the display; new data is still received  (Space)</source>
        <translation>Fige le dessin, jamais les données  (Espace)</translation>
    </message>
    <message>
        <source>Dark or light</source>
        <translation>Sombre ou clair</translation>
    </message>
    <message>
        <source>No GCM found at </source>
        <translation>Aucun GCM trouvé à </translation>
    </message>
    <message>
        <source>searching every second</source>
        <translation>recherche chaque seconde</translation>
    </message>
    <message>
        <source>GCM lost %1 ago</source>
        <translation>GCM perdu il y a %1</translation>
    </message>
    <message>
        <source>retrying </source>
        <translation>nouvel essai&#xa0;: </translation>
    </message>
    <message>
        <source>Hosting the GCM on this machine</source>
        <translation>GCM hébergé sur cette machine</translation>
    </message>
    <message>
        <source>GCM at </source>
        <translation>GCM à </translation>
    </message>
    <message>
        <source>The global component manager (GCM) at %1 knows every process and makes the connections between the processes.</source>
        <translation>Le gestionnaire global de composants (GCM) à %1 connaît chaque processus et établit leurs connexions.</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 problème</translation>
    </message>
    <message>
        <source>%1 problems</source>
        <translation>%1 problèmes</translation>
    </message>
    <message>
        <source>Resume view</source>
        <translation>Reprendre la vue</translation>
    </message>
    <message>
        <source>Search or run</source>
        <translation>Chercher ou exécuter</translation>
    </message>
    <message>
        <source>A command, or the name of an object</source>
        <translation>Que faire, ou un nom où aller</translation>
    </message>
    <message>
        <source>No match.</source>
        <translation>Aucun résultat.</translation>
    </message>
    <message>
        <source>&amp;System</source>
        <translation>&amp;Système</translation>
    </message>
    <message>
        <source>&amp;Plot</source>
        <translation>&amp;Graphique</translation>
    </message>
    <message>
        <source>&amp;Graph</source>
        <translation>G&amp;raphe</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
    <message>
        <source>Command for a terminal</source>
        <translation>Commande pour un terminal</translation>
    </message>
    <message>
        <source>Try the demo</source>
        <translation>Essayer la démo</translation>
    </message>
    <message>
        <source>Two processes with a simulated arm, on this machine.</source>
        <translation>Deux processus avec un bras simulé, sur cette machine.</translation>
    </message>
    <message>
        <source>Nothing is running yet.</source>
        <translation>Rien ne tourne encore.</translation>
    </message>
    <message>
        <source>A process that joins this GCM appears here automatically.</source>
        <translation>Un processus qui rejoint ce GCM apparaît ici de lui-même.</translation>
    </message>
    <message>
        <source>To start a process, type in a terminal:</source>
        <translation>Pour démarrer un processus, taper dans un terminal :</translation>
    </message>
    <message>
        <source>No GCM answers at %1.</source>
        <translation>Aucun GCM ne répond à %1.</translation>
    </message>
    <message>
        <source>The window tries again every second until a GCM answers.</source>
        <translation>La fenêtre réessaie chaque seconde, jusqu&apos;à ce qu&apos;un GCM réponde.</translation>
    </message>
    <message>
        <source>To start a GCM, type in a terminal of that machine:</source>
        <translation>Pour démarrer un GCM, taper dans un terminal de cette machine :</translation>
    </message>
    <message>
        <source>Diff</source>
        <translation>Différences</translation>
    </message>
    <message>
        <source>&amp;Open a system file…</source>
        <translation>&amp;Ouvrir un fichier de système…</translation>
    </message>
    <message>
        <source>Sa&amp;ve the running system</source>
        <translation>&amp;Enregistrer ce qui tourne</translation>
    </message>
    <message>
        <source>Save the running system &amp;as…</source>
        <translation>Enregistrer ce qui tourne &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Restore the system file…</source>
        <translation>&amp;Restaurer selon le fichier de système…</translation>
    </message>
    <message>
        <source>&amp;Go back to a state</source>
        <translation>Re&amp;venir à un état</translation>
    </message>
    <message>
        <source>The system file of the demo cannot be read: </source>
        <translation>Le fichier système de la démo ne peut pas être lu&#xa0;: </translation>
    </message>
    <message>
        <source>A plan is running; the demo starts after the plan</source>
        <translation>Un plan est en cours d&apos;exécution&#xa0;; la démo vient après</translation>
    </message>
    <message>
        <source>the demo</source>
        <translation>la démo</translation>
    </message>
    <message>
        <source>The demo is already running</source>
        <translation>La démo tourne déjà</translation>
    </message>
    <message>
        <source>Starting the demo: step %1 of %2</source>
        <translation>Démarrage de la démo&#xa0;: étape %1 sur %2</translation>
    </message>
    <message>
        <source>The demo was not started: </source>
        <translation>La démo n&apos;a pas été démarrée&#xa0;: </translation>
    </message>
    <message>
        <source>The demo runs: click a hollow port, then a port that lights up</source>
        <translation>La démo tourne&#xa0;: cliquer sur un port creux, puis sur un port qui s&apos;allume</translation>
    </message>
    <message>
        <source>System files (*%1)</source>
        <translation>Fichiers de système (*%1)</translation>
    </message>
    <message>
        <source>Open a system file</source>
        <translation>Ouvrir un fichier de système</translation>
    </message>
    <message>
        <source>Save the running system</source>
        <translation>Enregistrer ce qui tourne</translation>
    </message>
    <message>
        <source>Open a system file first: Ctrl+O</source>
        <translation>Ouvrir d&apos;abord un fichier de système&#xa0;: Ctrl+O</translation>
    </message>
    <message>
        <source>State at </source>
        <translation>État à </translation>
    </message>
    <message>
        <source>Nothing has changed yet</source>
        <translation>Rien n&apos;a encore changé</translation>
    </message>
    <message>
        <source>&amp;Find in the graph…</source>
        <translation>&amp;Chercher dans le graphe…</translation>
    </message>
    <message>
        <source>Show &amp;all of the graph</source>
        <translation>&amp;Tout montrer</translation>
    </message>
    <message>
        <source>&amp;Map of the graph</source>
        <translation>Carte du &amp;graphe</translation>
    </message>
    <message>
        <source>&amp;Undo the last move</source>
        <translation>&amp;Annuler le dernier déplacement</translation>
    </message>
    <message>
        <source>Nothing has been moved</source>
        <translation>Rien n&apos;a été déplacé</translation>
    </message>
    <message>
        <source>&amp;Reset the layout of the graph</source>
        <translation>&amp;Réinitialiser la disposition du graphe</translation>
    </message>
    <message>
        <source>All nodes are back at their automatic positions · Ctrl+Z undoes</source>
        <translation>Tous les nœuds sont revenus à leur place automatique · Ctrl+Z annule</translation>
    </message>
    <message>
        <source>Save a &amp;picture of the graph…</source>
        <translation>&amp;Enregistrer une image du graphe…</translation>
    </message>
    <message>
        <source>&amp;Copy the picture of the graph</source>
        <translation>Co&amp;pier l&apos;image du graphe</translation>
    </message>
    <message>
        <source>Moved back</source>
        <translation>Remis en place</translation>
    </message>
    <message>
        <source>Logo of Tendon</source>
        <translation>Logo de Tendon</translation>
    </message>
    <message>
        <source>Shows and controls a system of Tendon components.</source>
        <translation>Montre et pilote un système de composants Tendon.</translation>
    </message>
    <message>
        <source>Versions</source>
        <translation>Versions</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Bibliothèque</translation>
    </message>
    <message>
        <source>Terms of the library</source>
        <translation>Conditions de la bibliothèque</translation>
    </message>
    <message>
        <source>Libraries in this program, and their licences</source>
        <translation>Les bibliothèques de ce programme et leurs licences</translation>
    </message>
    <message>
        <source>Copy versions</source>
        <translation>Copier les versions</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Copié</translation>
    </message>
    <message>
        <source>About gcm-gui</source>
        <translation>À propos de gcm-gui</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Partout</translation>
    </message>
    <message>
        <source>Tab, Shift+Tab</source>
        <translation>Tab, Maj+Tab</translation>
    </message>
    <message>
        <source>Go to the next or previous part</source>
        <translation>Vers la partie suivante, précédente</translation>
    </message>
    <message>
        <source>The menus</source>
        <translation>Les menus</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Leave the connect mode, a card or a field</source>
        <translation>Quitte le mode de connexion, une fiche, un champ</translation>
    </message>
    <message>
        <source>In the graph</source>
        <translation>Dans le graphe</translation>
    </message>
    <message>
        <source>Arrows</source>
        <translation>Flèches</translation>
    </message>
    <message>
        <source>Select the next component</source>
        <translation>Sélectionner le composant suivant</translation>
    </message>
    <message>
        <source>Zoom in, zoom out, show all</source>
        <translation>Plus près, plus loin, tout</translation>
    </message>
    <message>
        <source>1 … 9, Enter</source>
        <translation>1 … 9, Entrée</translation>
    </message>
    <message>
        <source>While connecting: pick the candidate with this number, or the best candidate</source>
        <translation>Pendant la connexion&#xa0;: choisir le vis-à-vis de ce numéro, ou le meilleur</translation>
    </message>
    <message>
        <source>In a plot</source>
        <translation>Dans un graphique</translation>
    </message>
    <message>
        <source>Zoom in time; with Ctrl in values</source>
        <translation>Zoomer dans le temps&#xa0;; avec Ctrl dans les valeurs</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Gauche, Droite</translation>
    </message>
    <message>
        <source>Move in time</source>
        <translation>Se déplacer dans le temps</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Gauche</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Fin</translation>
    </message>
    <message>
        <source>Follow the data again</source>
        <translation>Suivre de nouveau les données</translation>
    </message>
    <message>
        <source>A, B, Delete</source>
        <translation>A, B, Suppr</translation>
    </message>
    <message>
        <source>Place or remove the cursors</source>
        <translation>Placer les curseurs, les retirer</translation>
    </message>
    <message>
        <source>In a plot&apos;s legend</source>
        <translation>Dans la légende d&apos;un graphique</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Hide or show the curve</source>
        <translation>Masquer la courbe, la montrer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>Remove the curve</source>
        <translation>Retirer la courbe</translation>
    </message>
    <message>
        <source>Show another signal instead</source>
        <translation>Un autre signal à sa place</translation>
    </message>
    <message>
        <source>In a form</source>
        <translation>Dans un formulaire</translation>
    </message>
    <message>
        <source>Call the command; if the command can move something, press these keys twice</source>
        <translation>Appeler la commande&#xa0;; une seconde fois si elle met quelque chose en mouvement</translation>
    </message>
    <message>
        <source>In the console</source>
        <translation>Dans la console</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Completes</source>
        <translation>Complète</translation>
    </message>
    <message>
        <source>Ctrl+R</source>
        <translation>Ctrl+R</translation>
    </message>
    <message>
        <source>Searches the history</source>
        <translation>Cherche dans ce qui a été tapé</translation>
    </message>
    <message>
        <source>Ctrl+C, Ctrl+L</source>
        <translation>Ctrl+C, Ctrl+L</translation>
    </message>
    <message>
        <source>Interrupts; clears</source>
        <translation>Interrompt&#xa0;; vide</translation>
    </message>
    <message>
        <source>Keys: </source>
        <translation>Touches&#xa0;: </translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Touches</translation>
    </message>
    <message>
        <source>The running system</source>
        <translation>Tout ce qui tourne</translation>
    </message>
    <message>
        <source>All processes with their components and interfaces appear here automatically; to find one, type into the filter.</source>
        <translation>Chaque processus, ses composants et leurs interfaces apparaissent ici d&apos;eux-mêmes&#xa0;; taper dans le filtre pour en chercher un.</translation>
    </message>
    <message>
        <source>Connect with two clicks</source>
        <translation>Connecter en deux clics</translation>
    </message>
    <message>
        <source>Click a hollow port, then a port that lights up: this connects the two ports, and Ctrl+Z undoes the connection.</source>
        <translation>Cliquer sur un port creux, puis sur un port qui s&apos;allume&#xa0;: ils sont connectés, et Ctrl+Z annule.</translation>
    </message>
    <message>
        <source>Look inside</source>
        <translation>Regarder à l&apos;intérieur</translation>
    </message>
    <message>
        <source>Values, commands and events of the selected object are shown here; a click on a command opens a form to call it.</source>
        <translation>Ce qui est sélectionné montre ici ses valeurs, commandes et événements, et un clic sur une commande donne un formulaire qui l&apos;appelle.</translation>
    </message>
    <message>
        <source>Plot it live</source>
        <translation>Tracer en direct</translation>
    </message>
    <message>
        <source>Select a value and press P: the plot shows all its samples, and you can zoom and measure while new ones arrive.</source>
        <translation>Sélectionner une valeur et appuyer sur P&#xa0;: chacun de ses échantillons est tracé, et vous pouvez zoomer et mesurer pendant que d&apos;autres arrivent.</translation>
    </message>
    <message>
        <source>Nothing is lost</source>
        <translation>Rien n&apos;est perdu</translation>
    </message>
    <message>
        <source>Your actions are listed here; you can undo each of them, or copy its command line. Other tabs show problems, the log and a console.</source>
        <translation>Vos actions sont listées ici ; chacune peut être annulée, ou copiée comme ligne de commande. D&apos;autres onglets montrent les problèmes, le journal et une console.</translation>
    </message>
    <message>
        <source>Find everything by name</source>
        <translation>Tout par son nom</translation>
    </message>
    <message>
        <source>Ctrl+K finds all commands and all objects. F1 shows the keys. The menu Help starts this tour again.</source>
        <translation>Ctrl+K trouve tout ce qui peut se faire et tout ce qui existe&#xa0;; F1 montre les touches, et le menu Aide cette visite.</translation>
    </message>
    <message>
        <source>Graph</source>
        <translation>Graphe</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Connexions</translation>
    </message>
    <message>
        <source>Nothing is connected.</source>
        <translation>Rien n&apos;est connecté.</translation>
    </message>
    <message>
        <source>Select an interface to connect it</source>
        <translation>Sélectionner une interface pour la connecter</translation>
    </message>
    <message>
        <source> has no unconnected required interface</source>
        <translation> n&apos;a aucune interface requise non connectée</translation>
    </message>
    <message>
        <source>Select a connected required interface to disconnect it</source>
        <translation>Sélectionner une interface requise connectée pour la déconnecter</translation>
    </message>
    <message>
        <source>Select a command of a provided interface to call it</source>
        <translation>Sélectionner une commande d&apos;une interface fournie pour l&apos;appeler</translation>
    </message>
    <message>
        <source>Hosting the GCM at %1 – gcm-gui</source>
        <translation>GCM hébergé à %1 – gcm-gui</translation>
    </message>
    <message>
        <source>GCM at %1 – gcm-gui</source>
        <translation>GCM à %1 – gcm-gui</translation>
    </message>
    <message>
        <source>The GCM is back after </source>
        <translation>Le GCM est de retour après </translation>
    </message>
    <message>
        <source>&amp;Connect…</source>
        <translation>&amp;Connecter…</translation>
    </message>
    <message>
        <source>&amp;Disconnect</source>
        <translation>&amp;Déconnecter</translation>
    </message>
    <message>
        <source>&amp;Why is the interface connected, or not?</source>
        <translation>&amp;Pourquoi est-ce connecté, ou non&#xa0;?</translation>
    </message>
    <message>
        <source>C&amp;all the command…</source>
        <translation>Appe&amp;ler la commande…</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>Ann&amp;uler</translation>
    </message>
    <message>
        <source>&amp;Filter the catalogue</source>
        <translation>&amp;Filtrer le catalogue</translation>
    </message>
    <message>
        <source>&amp;Show in graph and catalogue</source>
        <translation>&amp;Montrer dans le graphe et le catalogue</translation>
    </message>
    <message>
        <source>Search or &amp;run…</source>
        <translation>Chercher ou e&amp;xécuter…</translation>
    </message>
    <message>
        <source>C&amp;onsole</source>
        <translation>Co&amp;nsole</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>Call the command</source>
        <translation>Appeler la commande</translation>
    </message>
    <message>
        <source>&amp;Plot the selection</source>
        <translation>&amp;Tracer la sélection</translation>
    </message>
    <message>
        <source>&amp;New plot</source>
        <translation>&amp;Nouveau graphique</translation>
    </message>
    <message>
        <source>Plot &amp;below, with the same time</source>
        <translation>Graphique &amp;en dessous, avec le même temps</translation>
    </message>
    <message>
        <source>Close t&amp;his plot</source>
        <translation>Fermer &amp;ce graphique</translation>
    </message>
    <message>
        <source>Pause &amp;view</source>
        <translation>&amp;Figer la vue</translation>
    </message>
    <message>
        <source>Follow &amp;live data</source>
        <translation>Suivre le &amp;direct</translation>
    </message>
    <message>
        <source>Cursors &amp;A and B</source>
        <translation>Curseurs &amp;A et B</translation>
    </message>
    <message>
        <source>&amp;Save the visible samples as CSV…</source>
        <translation>Enregistrer la partie &amp;visible en CSV…</translation>
    </message>
    <message>
        <source>Save a p&amp;icture…</source>
        <translation>Enregistrer une &amp;image…</translation>
    </message>
    <message>
        <source>&amp;Open a layout of plots…</source>
        <translation>&amp;Ouvrir une disposition de graphiques…</translation>
    </message>
    <message>
        <source>Save the layou&amp;t of plots…</source>
        <translation>Enregistrer la di&amp;sposition des graphiques…</translation>
    </message>
    <message>
        <source>&amp;Tour of the window</source>
        <translation>&amp;Visite de la fenêtre</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>&amp;Touches</translation>
    </message>
    <message>
        <source>&amp;About gcm-gui</source>
        <translation>À &amp;propos de gcm-gui</translation>
    </message>
    <message>
        <source>Layout for connecting</source>
        <translation>Disposition pour connecter</translation>
    </message>
    <message>
        <source>Layout for plotting</source>
        <translation>Disposition pour tracer</translation>
    </message>
    <message>
        <source>Layout for operating</source>
        <translation>Disposition pour piloter</translation>
    </message>
    <message>
        <source>Layout for diagnosing</source>
        <translation>Disposition pour diagnostiquer</translation>
    </message>
    <message>
        <source>Panels can be moved</source>
        <translation>Panneaux déplaçables</translation>
    </message>
    <message>
        <source>Reset layout</source>
        <translation>Réinitialiser la disposition</translation>
    </message>
    <message>
        <source> cannot be plotted, because it is not a number; select a column or a value of a state table</source>
        <translation> ne peut pas être tracé, car ce n&apos;est pas un nombre&#xa0;; sélectionner une colonne ou une valeur d&apos;une table d&apos;état</translation>
    </message>
    <message>
        <source>The first %1 of %2 numbers are plotted; select fewer numbers</source>
        <translation>Les %1 premiers nombres sur %2 sont tracés&#xa0;; sélectionner moins de nombres</translation>
    </message>
    <message>
        <source>, and %1 more since the previous mark</source>
        <translation>, et %1 autres depuis la marque précédente</translation>
    </message>
    <message>
        <source>call </source>
        <translation>appel </translation>
    </message>
    <message>
        <source> by </source>
        <translation> par </translation>
    </message>
    <message>
        <source>: refused</source>
        <translation>, refusé</translation>
    </message>
    <message>
        <source> is back</source>
        <translation> est de retour</translation>
    </message>
    <message>
        <source> disconnected</source>
        <translation> déconnecté</translation>
    </message>
    <message>
        <source> is no longer connected to </source>
        <translation> n&apos;est plus connectée à </translation>
    </message>
    <message>
        <source> connected</source>
        <translation> connecté</translation>
    </message>
    <message>
        <source> is connected to </source>
        <translation> est connectée à </translation>
    </message>
    <message>
        <source>Smaller  (−)</source>
        <translation>Plus petit  (−)</translation>
    </message>
    <message>
        <source>Larger  (+)</source>
        <translation>Plus grand  (+)</translation>
    </message>
    <message>
        <source>Show all  (0)</source>
        <translation>Tout montrer  (0)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Démarrer</translation>
    </message>
    <message>
        <source>Suspend</source>
        <translation>Suspendre</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Redémarrer</translation>
    </message>
    <message>
        <source>Hold to start</source>
        <translation>Maintenir pour démarrer</translation>
    </message>
    <message>
        <source>Hold to suspend</source>
        <translation>Maintenir pour suspendre</translation>
    </message>
    <message>
        <source>Hold to stop</source>
        <translation>Maintenir pour arrêter</translation>
    </message>
    <message>
        <source>Hold to restart</source>
        <translation>Maintenir pour redémarrer</translation>
    </message>
    <message>
        <source>Nothing was done: hold the button for 0.4 s</source>
        <translation>Rien n&apos;a été fait : maintenez le bouton 0.4 s</translation>
    </message>
    <message>
        <source>This order can move something: hold the button for 0.4 s</source>
        <translation>Cela peut mettre quelque chose en mouvement : maintenez le bouton 0.4 s</translation>
    </message>
    <message>
        <source>This order can move something: hold the button for 0.4 s, or press Enter</source>
        <translation>Cela peut mettre quelque chose en mouvement : maintenez le bouton 0.4 s ou appuyez sur Entrée</translation>
    </message>
    <message>
        <source>Select a component to start, suspend, stop or restart it</source>
        <translation>Sélectionnez un composant pour le démarrer, le suspendre, l&apos;arrêter ou le redémarrer</translation>
    </message>
    <message>
        <source>%1 has been restarted in %2</source>
        <translation>%1 a redémarré en %2</translation>
    </message>
    <message>
        <source>%1: %2 done in %3 · Ctrl+Z twice undoes</source>
        <translation>%1 : %2 fait en %3 · Ctrl+Z deux fois annule</translation>
    </message>
    <message>
        <source>Why is the interface connected, or not?</source>
        <translation>Pourquoi est-ce connecté, ou non&#xa0;?</translation>
    </message>
    <message>
        <source>Start or stop</source>
        <translation>Démarrer ou arrêter</translation>
    </message>
    <message>
        <source>This order stops what the component does: hold the button for 0.4 s</source>
        <translation>Cela met fin à ce que fait le composant : maintenir le bouton 0.4 s</translation>
    </message>
    <message>
        <source>This order stops what the component does: hold the button for 0.4 s, or press Enter</source>
        <translation>Cela met fin à ce que fait le composant : maintenir le bouton 0.4 s ou appuyer sur Entrée</translation>
    </message>
    <message>
        <source>%1 has not answered for %2 s: click, or press Enter, to ask again</source>
        <translation>%1 n&apos;a pas répondu depuis %2 s : un clic ou Entrée redemande</translation>
    </message>
    <message>
        <source>no reply in %1 s · ask again</source>
        <translation>pas de réponse en %1 s · redemander</translation>
    </message>
    <message>
        <source>%1 old</source>
        <translation>vieux de %1</translation>
    </message>
    <message>
        <source>the thread of %1</source>
        <translation>le thread de %1</translation>
    </message>
    <message>
        <source>none of its own</source>
        <translation>aucun à lui</translation>
    </message>
    <message>
        <source>its own</source>
        <translation>le sien</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normale</translation>
    </message>
    <message>
        <source>any</source>
        <translation>tous</translation>
    </message>
    <message>
        <source>Wanted period</source>
        <translation>Période voulue</translation>
    </message>
    <message>
        <source>Longest period</source>
        <translation>Période la plus longue</translation>
    </message>
    <message>
        <source>Mean of the last second</source>
        <translation>Moyenne de la dernière seconde</translation>
    </message>
    <message>
        <source>Median of the last second: half of the cycles start at most this late</source>
        <translation>Médiane de la dernière seconde : la moitié des cycles commence au plus avec ce retard</translation>
    </message>
    <message>
        <source>99 of 100 start within</source>
        <translation>99 sur 100 partent en</translation>
    </message>
    <message>
        <source>Latest start</source>
        <translation>Départ le plus tardif</translation>
    </message>
    <message>
        <source>Computes for</source>
        <translation>Calcule pendant</translation>
    </message>
    <message>
        <source>Longest computation</source>
        <translation>Calcul le plus long</translation>
    </message>
    <message>
        <source>Thread</source>
        <translation>Thread</translation>
    </message>
    <message>
        <source>Scheduling</source>
        <translation>Ordonnancement</translation>
    </message>
    <message>
        <source>Processors</source>
        <translation>Processeurs</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Avertissement</translation>
    </message>
    <message>
        <source>Rename this plot</source>
        <translation>Renommer ce graphique</translation>
    </message>
    <message>
        <source>Name; leave it empty for the default name</source>
        <translation>Nom ; vide : d&apos;après ce qu&apos;il montre</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>&amp;Rename this plot…</source>
        <translation>&amp;Renommer ce graphique…</translation>
    </message>
    <message>
        <source>Keys of &amp;this part</source>
        <translation>&amp;Touches de cette partie</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Rien n&apos;a été annulé qui puisse être refait</translation>
    </message>
    <message>
        <source>Starting and stopping cannot be redone: start or stop the component again, for example with F6 to F9</source>
        <translation>Démarrer et arrêter ne se rétablit pas : donnez l’ordre à nouveau, par exemple avec F6 à F9</translation>
    </message>
    <message>
        <source>%1 in its process</source>
        <translation>%1 dans son processus</translation>
    </message>
    <message>
        <source>%1 on the network</source>
        <translation>%1 sur le réseau</translation>
    </message>
    <message>
        <source>%1 in this window</source>
        <translation>%1 dans cette fenêtre</translation>
    </message>
    <message>
        <source>; lost </source>
        <translation>; perdues : </translation>
    </message>
    <message>
        <source>Imported to </source>
        <translation>Importé dans </translation>
    </message>
    <message>
        <source>Import a cisst file</source>
        <translation>Importer un fichier cisst</translation>
    </message>
    <message>
        <source>&amp;Import a cisst file…</source>
        <translation>&amp;Importer un fichier cisst…</translation>
    </message>
    <message>
        <source>Files of a cisst component manager (*.json)</source>
        <translation>Fichiers d&apos;un gestionnaire de composants cisst (*.json)</translation>
    </message>
    <message>
        <source>The process to which the components belong</source>
        <translation>Le processus auquel appartiennent les composants</translation>
    </message>
    <message>
        <source>Connect to another machine</source>
        <translation>Se connecter à une autre machine</translation>
    </message>
    <message>
        <source>Connect to another machine…</source>
        <translation>Se connecter à une autre machine…</translation>
    </message>
    <message>
        <source>Connect to another &amp;machine…</source>
        <translation>Se connecter à une autre &amp;machine…</translation>
    </message>
    <message>
        <source>Address of the GCM on that machine, such as robot1 or robot1:10705</source>
        <translation>Adresse du GCM de cette machine, comme robot1 ou robot1:10705</translation>
    </message>
    <message>
        <source>Another window could not be started; type in a terminal: gcm-gui --gcm %1</source>
        <translation>Une autre fenêtre n&apos;a pas pu être lancée ; taper dans un terminal : gcm-gui --gcm %1</translation>
    </message>
    <message>
        <source>Shows or hides processes that have been gone for half a minute</source>
        <translation>Processus absents depuis une demi-minute : les montre ou les cache</translation>
    </message>
    <message>
        <source>gone (%1)</source>
        <translation>absents (%1)</translation>
    </message>
    <message>
        <source>%1 already exists: open it, or remove it before the import</source>
        <translation>%1 existe déjà : ouvrez-le, ou supprimez-le avant l’importation</translation>
    </message>
    <message>
        <source>%1 is shown in another window; this window stays open, because it hosts a GCM</source>
        <translation>%1 est montré dans une autre fenêtre ; celle-ci héberge un GCM et reste ouverte</translation>
    </message>
    <message>
        <source>%1 · ask again</source>
        <translation>%1 · redemander</translation>
    </message>
    <message>
        <source>Start the component</source>
        <translation>Démarrer le composant</translation>
    </message>
    <message>
        <source>Start %1 components</source>
        <translation>Démarrer %1 composants</translation>
    </message>
    <message>
        <source>Suspend the component</source>
        <translation>Suspendre le composant</translation>
    </message>
    <message>
        <source>Suspend %1 components</source>
        <translation>Suspendre %1 composants</translation>
    </message>
    <message>
        <source>Stop the component</source>
        <translation>Arrêter le composant</translation>
    </message>
    <message>
        <source>Stop %1 components</source>
        <translation>Arrêter %1 composants</translation>
    </message>
    <message>
        <source>Restart the component</source>
        <translation>Redémarrer le composant</translation>
    </message>
    <message>
        <source>Restart %1 components</source>
        <translation>Redémarrer %1 composants</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>échoué</translation>
    </message>
    <message>
        <source>left</source>
        <translation>restant</translation>
    </message>
    <message>
        <source>Target %1: asking the processes for their classes…</source>
        <translation>Cible %1 : on demande aux processus ce qu’ils peuvent créer…</translation>
    </message>
    <message>
        <source>Target %1: %2; %3</source>
        <translation>Cible %1 : %2 ; %3</translation>
    </message>
    <message>
        <source>this GCM is too old to report which processes it has started</source>
        <translation>ce GCM est trop ancien pour dire qui il a lancé</translation>
    </message>
    <message>
        <source>Start a GCM here</source>
        <translation>Lancer un GCM ici</translation>
    </message>
    <message>
        <source>Show me around</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Starting a GCM; it keeps running when this window is closed</source>
        <translation>Un GCM est lancé ; il continue quand cette fenêtre est fermée</translation>
    </message>
    <message>
        <source>%1 could not be started: check that it is installed</source>
        <translation>%1 n’a pas pu être lancé : vérifier qu’il est installé</translation>
    </message>
    <message>
        <source>Current values from %1</source>
        <translation>Valeurs actuelles de %1</translation>
    </message>
    <message>
        <source>Reload everythi&amp;ng</source>
        <translation>Tout &amp;redemander</translation>
    </message>
    <message>
        <source>Everything is loaded from the GCM again</source>
        <translation>Tout est redemandé au GCM</translation>
    </message>
    <message>
        <source>No GCM answers; the window tries again each second</source>
        <translation>Il n’y a pas de GCM ; il est cherché chaque seconde</translation>
    </message>
    <message>
        <source>State / value</source>
        <translation>État / valeur</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Fréquence</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Âge</translation>
    </message>
    <message>
        <source>Connected to</source>
        <translation>Connecté à</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>Rows per second that arrive in this window. “–” means no subscription</source>
        <translation>Lignes par seconde qui arrivent ici. « – » : pas d&apos;abonnement</translation>
    </message>
    <message>
        <source>For a value: time since its newest row was written. For a process: time since its state changed. “–” means unknown</source>
        <translation>Valeur : temps depuis l&apos;écriture de sa dernière ligne. Processus : temps depuis le changement de son état. « – » : inconnu</translation>
    </message>
    <message>
        <source>The connected interfaces; for a component, the connected components</source>
        <translation>Les interfaces, ou pour un composant les composants, à l&apos;autre bout</translation>
    </message>
    <message>
        <source>Columns of the catalogue</source>
        <translation>Colonnes du catalogue</translation>
    </message>
    <message>
        <source>Column: state and value</source>
        <translation>Colonne : état et valeur</translation>
    </message>
    <message>
        <source>Column: rate</source>
        <translation>Colonne : fréquence</translation>
    </message>
    <message>
        <source>Column: age</source>
        <translation>Colonne : âge</translation>
    </message>
    <message>
        <source>Column: connected to</source>
        <translation>Colonne : connecté à</translation>
    </message>
    <message>
        <source>A scale of 0 would draw a flat line: choose another scale</source>
        <translation>Une échelle de 0 en ferait une ligne plate : en prendre une autre</translation>
    </message>
    <message>
        <source>The scale must lie between %1 and %2, with either sign</source>
        <translation>L&apos;échelle doit être entre %1 et %2, quel que soit le signe</translation>
    </message>
    <message>
        <source>The offset must lie between -%1 and %1</source>
        <translation>Le décalage doit être entre -%1 et %1</translation>
    </message>
    <message>
        <source>The name of an axis has at most %1 letters</source>
        <translation>Le nom d&apos;un axe a au plus %1 lettres</translation>
    </message>
    <message>
        <source>The name of an axis must be one line without control characters</source>
        <translation>Le nom d&apos;un axe doit tenir sur une ligne, sans caractères de contrôle</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Afficher ainsi</translation>
    </message>
    <message>
        <source>Scale, offset and axis of </source>
        <translation>Échelle, décalage et axe de </translation>
    </message>
    <message>
        <source>Curves with the same name here share one axis; a new name makes a new axis</source>
        <translation>Les courbes de même axe le partagent ; un nom à vous en crée un</translation>
    </message>
    <message>
        <source>Unscaled</source>
        <translation>Telle quelle</translation>
    </message>
    <message>
        <source>Removes scale and offset, and uses the axis of the unit</source>
        <translation>Retire l&apos;échelle et le décalage, et prend l&apos;axe de l&apos;unité</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Axe</translation>
    </message>
    <message>
        <source>Axis of its unit</source>
        <translation>Celui de son unité</translation>
    </message>
    <message>
        <source>The scale “%1” is not a number</source>
        <translation>L&apos;échelle « %1 » n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>The offset “%1” is not a number</source>
        <translation>Le décalage « %1 » n&apos;est pas un nombre</translation>
    </message>
    <message>
        <source>Shown: value %1</source>
        <translation>Affiché : valeur %1</translation>
    </message>
    <message>
        <source>Shown unscaled</source>
        <translation>Affichée telle quelle</translation>
    </message>
    <message>
        <source>; the values are not scaled</source>
        <translation>; valeurs telles quelles, sans échelle</translation>
    </message>
    <message>
        <source>Scale, offset and axis…</source>
        <translation>Échelle, décalage et axe…</translation>
    </message>
    <message>
        <source>Hide</source>
        <translation>Masquer</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Show another signal…</source>
        <translation>Afficher un autre signal…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Retirer</translation>
    </message>
    <message>
        <source>a curve has no path: give each curve a text &quot;path&quot;</source>
        <translation>une courbe n&apos;a pas de chemin : donner à chaque courbe un texte « path »</translation>
    </message>
    <message>
        <source>scale and offset of %1 must be numbers</source>
        <translation>l&apos;échelle et le décalage de %1 doivent être des nombres</translation>
    </message>
    <message>
        <source>&quot;axis&quot; of %1 must be text in quotes</source>
        <translation>&quot;axis&quot; de %1 doit être un texte entre guillemets</translation>
    </message>
    <message>
        <source>the list &quot;curves&quot; is missing</source>
        <translation>la liste « curves » manque</translation>
    </message>
    <message>
        <source>&quot;window&quot; must be above 0 and at most %1 s</source>
        <translation>« window » doit être supérieur à 0 et au plus %1 s</translation>
    </message>
    <message>
        <source>plot %1: </source>
        <translation>tracé %1 : </translation>
    </message>
    <message>
        <source>not JSON: %1</source>
        <translation>pas du JSON : %1</translation>
    </message>
    <message>
        <source>version %1 of plot layouts is not supported; this program supports version %2</source>
        <translation>la version %1 des dispositions n’est pas prise en charge ; ce programme prend en charge la version %2</translation>
    </message>
    <message>
        <source>the file contains no plot: choose another file</source>
        <translation>le fichier ne contient aucun tracé : choisir un autre fichier</translation>
    </message>
    <message>
        <source>constructed</source>
        <translation>construit</translation>
    </message>
    <message>
        <source>ready</source>
        <translation>prêt</translation>
    </message>
    <message>
        <source>active</source>
        <translation>actif</translation>
    </message>
    <message>
        <source>suspended</source>
        <translation>suspendu</translation>
    </message>
    <message>
        <source>finished</source>
        <translation>terminé</translation>
    </message>
    <message>
        <source>faulted</source>
        <translation>en défaut</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>connecté</translation>
    </message>
    <message>
        <source>pending</source>
        <translation>en attente</translation>
    </message>
    <message>
        <source>not connected</source>
        <translation>non connecté</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>refusé</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>avertissement</translation>
    </message>
    <message>
        <source>lost</source>
        <translation>perdu</translation>
    </message>
    <message>
        <source>alive</source>
        <translation>en vie</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>démarre</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 est %2</translation>
    </message>
    <message>
        <source>fits</source>
        <translation>convient</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maint.</translation>
    </message>
    <message>
        <source>restarted</source>
        <translation>redémarré</translation>
    </message>
    <message>
        <source>remap…</source>
        <translation>remplacer…</translation>
    </message>
    <message>
        <source>same</source>
        <translation>identique</translation>
    </message>
    <message>
        <source>offered</source>
        <translation>fourni</translation>
    </message>
    <message>
        <source>optional, not offered</source>
        <translation>facultatif, non fourni</translation>
    </message>
    <message>
        <source>not needed</source>
        <translation>non requis</translation>
    </message>
    <message>
        <source>To undo &apos;%2&apos; (by %3, %4 ago), press Ctrl+Z again within %1 s</source>
        <translation>Ctrl+Z encore une fois en %1 s annule « %2 », par %3 il y a %4</translation>
    </message>
    <message>
        <source>; this undo can move something</source>
        <translation>; l&apos;annuler peut mettre quelque chose en mouvement</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>il n&apos;y a rien à annuler</translation>
    </message>
    <message>
        <source>process &apos;%1&apos; is lost%2; it is unknown whether the command was executed or will still be executed: check the component before you repeat the call</source>
        <translation>le processus « %1 » est perdu%2 ; on ignore si la commande a été ou sera exécutée : vérifier le composant avant de répéter l’appel</translation>
    </message>
    <message>
        <source>this window cannot change anything: it was started with --read-only</source>
        <translation>cette fenêtre ne peut rien modifier : elle a été lancée avec --read-only</translation>
    </message>
    <message>
        <source>%1: current values from %2</source>
        <translation>%1 : valeurs actuelles de %2</translation>
    </message>
    <message>
        <source>These are not the current values: %1 does not report the current values</source>
        <translation>Ce ne sont pas les valeurs actuelles : %1 ne donne pas les valeurs actuelles</translation>
    </message>
    <message>
        <source>left</source>
        <comment>of a process</comment>
        <translation>parti</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Scale, offset and axis</source>
        <translation>Échelle, décalage et axe</translation>
    </message>
    <message>
        <source>To be corrected: %1</source>
        <translation>À corriger : %1</translation>
    </message>
    <message>
        <source>put a space after each comma between numbers</source>
        <translation>mettre une espace après chaque virgule entre les nombres</translation>
    </message>
    <message>
        <source>a number is missing in the list</source>
        <translation>il manque un nombre dans la liste</translation>
    </message>
    <message>
        <source>it is not clear whether “%1” is one number or several: put semicolons between numbers</source>
        <translation>on ne sait pas si « %1 » est un nombre ou plusieurs : mettre des points-virgules entre les nombres</translation>
    </message>
    <message>
        <source>write a number from %1 to %2</source>
        <translation>écrire un nombre de %1 à %2</translation>
    </message>
    <message>
        <source>Nothing was pasted: %1</source>
        <translation>Rien n’a été collé : %1</translation>
    </message>
    <message>
        <source>expected one number, found %1</source>
        <translation>il faut ici un nombre, et il y en a %1</translation>
    </message>
    <message>
        <source>expected at most %2 numbers from this field on, found %1</source>
        <translation>il y a %1 nombres, et %2 champs à partir d’ici</translation>
    </message>
    <message>
        <source> or </source>
        <translation> ou </translation>
    </message>
    <message>
        <source>a number is missing</source>
        <translation>il manque un nombre</translation>
    </message>
    <message>
        <source>write %1: use a point as the decimal sign, and no separator between thousands</source>
        <translation>écrire %1 : le signe décimal est un point, et rien ne sépare les milliers</translation>
    </message>
    <message>
        <source>write %1: use a point as the decimal sign</source>
        <translation>écrire %1 : le signe décimal est un point</translation>
    </message>
    <message>
        <source>write %1: use no separator between thousands</source>
        <translation>écrire %1 : rien ne sépare les milliers</translation>
    </message>
    <message>
        <source>write %1</source>
        <translation>écrire %1</translation>
    </message>
    <message>
        <source>write the number alone, without “%1”</source>
        <translation>écrire le nombre seul, sans « %1 »</translation>
    </message>
    <message>
        <source>write the number alone, in %1</source>
        <translation>écrire le nombre seul, en %1</translation>
    </message>
    <message>
        <source>write a whole number</source>
        <translation>écrire un nombre entier</translation>
    </message>
    <message>
        <source>the type of this field cannot hold this number</source>
        <translation>le type de ce champ ne peut contenir un tel nombre</translation>
    </message>
    <message>
        <source>write a number in digits</source>
        <translation>écrire un nombre en chiffres</translation>
    </message>
    <message>
        <source>: use a point as the decimal sign</source>
        <translation>: le signe décimal est un point</translation>
    </message>
    <message>
        <source>%1 is not drawn because of an error: %2</source>
        <translation>%1 a rencontré une erreur et n&apos;est pas dessiné : %2</translation>
    </message>
    <message>
        <source>%1 had an error: %2</source>
        <translation>%1 a rencontré une erreur : %2</translation>
    </message>
    <message>
        <source> (%1 times)</source>
        <translation> (%1 fois)</translation>
    </message>
    <message>
        <source>there is not enough memory</source>
        <translation>il n’y a pas assez de mémoire</translation>
    </message>
    <message>
        <source>an exception without a message</source>
        <translation>une exception sans texte</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>This view is not drawn because of an error: see Problems.</source>
        <translation>Cette vue n&apos;est pas dessinée à cause d&apos;une erreur : voir Problèmes.</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Afficher à nouveau</translation>
    </message>
    <message>
        <source>Inspector: values</source>
        <translation>Inspecteur : valeurs</translation>
    </message>
    <message>
        <source>Inspector: events</source>
        <translation>Inspecteur : événements</translation>
    </message>
    <message>
        <source>Inspector: call</source>
        <translation>Inspecteur : appel</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>non démarré</translation>
    </message>
    <message>
        <source>did not run</source>
        <translation>à l’arrêt</translation>
    </message>
    <message>
        <source> cannot be shown: </source>
        <translation> ne peut pas être affiché : </translation>
    </message>
    <message>
        <source>The component is notified that it was suspended. If its author has written code for this case, the component starts from the current situation; otherwise the component continues its previous action.</source>
        <translation>Le composant est informé qu&apos;il était suspendu. Si son auteur l&apos;a prévu, il part de la situation actuelle ; sinon il continue son action précédente.</translation>
    </message>
    <message>
        <source>The component starts from the beginning: no previous action continues.</source>
        <translation>Le composant repart du début : aucune action précédente ne continue.</translation>
    </message>
    <message>
        <source>%1 for %2</source>
        <comment>a state, a time</comment>
        <translation>%1 depuis %2</translation>
    </message>
    <message>
        <source>%1 had an error: see Problems</source>
        <translation>%1 a rencontré une erreur : voir Problèmes</translation>
    </message>
    <message>
        <source> waits for </source>
        <translation> attend </translation>
    </message>
    <message>
        <source>Waits for</source>
        <translation>Attend</translation>
    </message>
    <message>
        <source> runs </source>
        <translation> exécute </translation>
    </message>
    <message>
        <source>the file is missing: restore the file before you restart the process</source>
        <translation>le fichier a disparu : le remettre avant de relancer le processus</translation>
    </message>
    <message>
        <source>the file was written again at %1: restart the process to use the new file</source>
        <translation>le fichier a été réécrit à %1 : relancer le processus pour l’exécuter</translation>
    </message>
    <message>
        <source>Plug-in</source>
        <translation>Module</translation>
    </message>
    <message>
        <source>File has changed</source>
        <translation>Fichier modifié</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>a file, and when it was written</comment>
        <translation>%1 du %2</translation>
    </message>
    <message>
        <source>the console</source>
        <translation>la console</translation>
    </message>
    <message>
        <source>a picture for the clipboard</source>
        <translation>une image pour le presse-papiers</translation>
    </message>
    <message>
        <source>the layout of the graph</source>
        <translation>la disposition du graphe</translation>
    </message>
    <message>
        <source>the reading of a file</source>
        <translation>la lecture d’un fichier</translation>
    </message>
    <message>
        <source>a step of a plan</source>
        <translation>une étape d’un plan</translation>
    </message>
    <message>
        <source>a system file</source>
        <translation>un fichier système</translation>
    </message>
    <message>
        <source>the comparison with a system file</source>
        <translation>la comparaison avec un fichier système</translation>
    </message>
    <message>
        <source>The action ends unless the command is called again within %1</source>
        <translation>L’action s’arrête si la commande n’est pas rappelée sous %1</translation>
    </message>
    <message>
        <source>%1 curves</source>
        <translation>%1 courbes</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Écrit</translation>
    </message>
    <message>
        <source>&amp;Record</source>
        <translation>&amp;Enregistrement</translation>
    </message>
    <message>
        <source>Alt+S, P, R, G, V, H</source>
        <translation>Alt+S, G, E, R, V, A</translation>
    </message>
    <message>
        <source>Records the plotted signals into a file  (Ctrl+R)</source>
        <translation>Enregistre les signaux tracés dans un fichier  (Ctrl+R)</translation>
    </message>
    <message>
        <source>Records the selected component into a file  (Ctrl+R)</source>
        <translation>Enregistre le composant choisi dans un fichier  (Ctrl+R)</translation>
    </message>
    <message>
        <source>Records everything into a file  (Ctrl+R)</source>
        <translation>Enregistre tout dans un fichier  (Ctrl+R)</translation>
    </message>
    <message>
        <source>What to record</source>
        <translation>Ce qui est enregistré</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Stop the recording</source>
        <translation>Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Completes the file  (Ctrl+R)</source>
        <translation>Termine le fichier  (Ctrl+R)</translation>
    </message>
    <message>
        <source>%1 plotted signal</source>
        <translation>%1 signal tracé</translation>
    </message>
    <message>
        <source>%1 plotted signals</source>
        <translation>%1 signaux tracés</translation>
    </message>
    <message>
        <source>everything</source>
        <translation>tout</translation>
    </message>
    <message>
        <source>Nothing is plotted</source>
        <translation>Rien n’est tracé</translation>
    </message>
    <message>
        <source>Nothing is selected</source>
        <translation>Rien n’est sélectionné</translation>
    </message>
    <message>
        <source>Plot a signal (P), or select another subject in the menu Record.</source>
        <translation>Tracer un signal (P), ou choisir autre chose dans le menu Enregistrement.</translation>
    </message>
    <message>
        <source>Select a component, or select another subject in the menu Record.</source>
        <translation>Sélectionner un composant, ou choisir autre chose dans le menu Enregistrement.</translation>
    </message>
    <message>
        <source>Nothing is recorded</source>
        <translation>Rien n’est enregistré</translation>
    </message>
    <message>
        <source>The recording continues: %1</source>
        <translation>L’enregistrement continue&#xa0;: %1</translation>
    </message>
    <message>
        <source>The recording has stopped</source>
        <translation>L’enregistrement s’est arrêté</translation>
    </message>
    <message>
        <source>Recorded %1 rows in %2 (%3, %4 lost)</source>
        <translation>%1 lignes enregistrées en %2 (%3, %4 perdues)</translation>
    </message>
    <message>
        <source>Show in folder</source>
        <translation>Montrer dans le dossier</translation>
    </message>
    <message>
        <source>Copy path</source>
        <translation>Copier le chemin</translation>
    </message>
    <message>
        <source>Choose a folder…</source>
        <translation>Choisir un dossier…</translation>
    </message>
    <message>
        <source>Close this line</source>
        <translation>Fermer cette ligne</translation>
    </message>
    <message>
        <source>Growth of the file in the last five seconds</source>
        <translation>Croissance du fichier dans les cinq dernières secondes</translation>
    </message>
    <message>
        <source>Size of the file</source>
        <translation>Taille du fichier</translation>
    </message>
    <message>
        <source>Completing the file</source>
        <translation>Le fichier est terminé</translation>
    </message>
    <message>
        <source>Starting to record</source>
        <translation>L’enregistrement commence</translation>
    </message>
    <message>
        <source>Saving the last %1 s</source>
        <translation>Enregistre les %1 dernières s</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistre</translation>
    </message>
    <message>
        <source>Was interrupted</source>
        <translation>A été interrompu</translation>
    </message>
    <message>
        <source>%1 rows</source>
        <translation>%1 lignes</translation>
    </message>
    <message>
        <source>%1 rows, %2 events, %3 commands, %4 records of the log</source>
        <translation>%1 lignes, %2 événements, %3 commandes, %4 entrées du journal</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 libres</translation>
    </message>
    <message>
        <source>Free space on the disk of the file</source>
        <translation>Place libre sur le disque du fichier</translation>
    </message>
    <message>
        <source>Every row and event is in the file.</source>
        <translation>Toutes les lignes et tous les événements sont dans le fichier.</translation>
    </message>
    <message>
        <source>%1 in this window, because the disk was too slow</source>
        <translation>%1 dans cette fenêtre, parce que le disque était trop lent</translation>
    </message>
    <message>
        <source>%1: rows lost: %2</source>
        <translation>%1&#xa0;: lignes perdues&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1: events lost: %2</source>
        <translation>%1&#xa0;: événements perdus&#xa0;: %2</translation>
    </message>
    <message>
        <source>Records of the log lost: %1</source>
        <translation>Entrées du journal perdues&#xa0;: %1</translation>
    </message>
    <message>
        <source>The disk is almost full.</source>
        <translation>Le disque est presque plein.</translation>
    </message>
    <message>
        <source>At this rate, the disk is full in %1 (minutes and seconds).</source>
        <translation>À ce rythme, le disque est plein dans %1 (minutes et secondes).</translation>
    </message>
    <message>
        <source>the folder %1 cannot be created: %2</source>
        <translation>le dossier %1 ne peut pas être créé&#xa0;: %2</translation>
    </message>
    <message>
        <source>&amp;Start recording</source>
        <translation>&amp;Démarrer l’enregistrement</translation>
    </message>
    <message>
        <source>Save the &amp;last 30 s</source>
        <translation>Enregistrer les 30 &amp;dernières s</translation>
    </message>
    <message>
        <source>Nothing is saved</source>
        <translation>Rien n’est enregistré</translation>
    </message>
    <message>
        <source>Saved the last %1 s: %2 rows, %3 events (%4)</source>
        <translation>Les %1 dernières s sont enregistrées : %2 lignes, %3 événements (%4)</translation>
    </message>
    <message>
        <source>Rows, events and log of the last seconds, which can be saved at any time: Record, Save the last 30 s</source>
        <translation>Lignes, événements et journal des dernières secondes, que l’on peut enregistrer à tout moment : Enregistrement, Enregistrer les 30 dernières s</translation>
    </message>
    <message>
        <source>History</source>
        <translation>Historique</translation>
    </message>
    <message>
        <source>&amp;Folder for recordings…</source>
        <translation>Dossier des enre&amp;gistrements…</translation>
    </message>
    <message>
        <source>What to record: &amp;plotted signals</source>
        <translation>À enregistrer&#xa0;: signaux &amp;tracés</translation>
    </message>
    <message>
        <source>What to record: selected &amp;component</source>
        <translation>À enregistrer&#xa0;: &amp;composant choisi</translation>
    </message>
    <message>
        <source>What to record: &amp;everything</source>
        <translation>À enregistrer&#xa0;: t&amp;out</translation>
    </message>
    <message>
        <source>&amp;Stop recording</source>
        <translation>&amp;Arrêter l’enregistrement</translation>
    </message>
    <message>
        <source>Folder for recordings</source>
        <translation>Dossier des enregistrements</translation>
    </message>
    <message>
        <source>Recordings go to %1</source>
        <translation>Les enregistrements vont dans %1</translation>
    </message>
    <message>
        <source>No file manager could be started; the file is in %1</source>
        <translation>Aucun gestionnaire de fichiers n’a pu démarrer&#xa0;; le fichier est dans %1</translation>
    </message>
    <message>
        <source>The path is in the clipboard</source>
        <translation>Le chemin est dans le presse-papiers</translation>
    </message>
    <message>
        <source>Open a recor&amp;ding…</source>
        <translation>&amp;Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Open a recording</source>
        <translation>Ouvrir un enregistrement</translation>
    </message>
    <message>
        <source>Recordings (*.mcap)</source>
        <translation>Enregistrements (*.mcap)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 cannot be opened, because %2 cannot be started</source>
        <translation>Impossible d’ouvrir %1, car %2 ne démarre pas</translation>
    </message>
    <message>
        <source>%1 opens in a separate window</source>
        <translation>%1 s’ouvre dans sa propre fenêtre</translation>
    </message>
    <message>
        <source>Open another recording…</source>
        <translation>Ouvrir un autre enregistrement…</translation>
    </message>
    <message>
        <source>%1 is being opened</source>
        <translation>Ouverture de %1</translation>
    </message>
    <message>
        <source>A file without an index, such as a file that is still being written, must first be read completely.</source>
        <translation>Un fichier sans index, par exemple en cours d’écriture, est d’abord lu en entier.</translation>
    </message>
    <message>
        <source>%1 cannot be shown</source>
        <translation>Impossible de montrer %1</translation>
    </message>
    <message>
        <source>No component at this moment</source>
        <translation>Aucun composant à cet instant</translation>
    </message>
    <message>
        <source>The recording has no component at this moment. Move the slider above, or look at the catalogue and the log.</source>
        <translation>L’enregistrement n’a aucun composant à cet instant. Déplacer le curseur ci-dessus, ou regarder le catalogue et le journal.</translation>
    </message>
    <message>
        <source>the reading of a recording</source>
        <translation>la lecture d’un enregistrement</translation>
    </message>
    <message>
        <source>This window shows the recording %1: nothing in it can be changed</source>
        <translation>Cette fenêtre montre l’enregistrement %1&#xa0;: rien ne peut y être modifié</translation>
    </message>
    <message>
        <source>this type is not in the recording</source>
        <translation>ce type n’est pas dans l’enregistrement</translation>
    </message>
    <message>
        <source>There is no event, loss or mark after this moment</source>
        <translation>Aucun événement, perte ou repère après cet instant</translation>
    </message>
    <message>
        <source>There is no event, loss or mark before this moment</source>
        <translation>Aucun événement, perte ou repère avant cet instant</translation>
    </message>
    <message>
        <source>Previous event, loss or mark</source>
        <translation>Événement, perte ou repère précédent</translation>
    </message>
    <message>
        <source>One row or event back</source>
        <translation>Reculer d’une ligne ou d’un événement</translation>
    </message>
    <message>
        <source>One row or event forward</source>
        <translation>Avancer d’une ligne ou d’un événement</translation>
    </message>
    <message>
        <source>Next event, loss or mark</source>
        <translation>Événement, perte ou repère suivant</translation>
    </message>
    <message>
        <source>The recording is being opened</source>
        <translation>L’enregistrement s’ouvre</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How fast the recording is played</source>
        <translation>Vitesse de lecture de l’enregistrement</translation>
    </message>
    <message>
        <source>Restart at the end</source>
        <translation>Recommencer à la fin</translation>
    </message>
    <message>
        <source>Mark this moment, or remove its mark</source>
        <translation>Marquer cet instant, ou enlever son repère</translation>
    </message>
    <message>
        <source>Copy the command gcm recover</source>
        <translation>Copier la commande gcm recover</translation>
    </message>
    <message>
        <source>In the clipboard: %1</source>
        <translation>Dans le presse-papiers&#xa0;: %1</translation>
    </message>
    <message>
        <source>Load newer data</source>
        <translation>Charger la suite</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>is being opened…</source>
        <translation>s’ouvre…</translation>
    </message>
    <message>
        <source>cannot be shown</source>
        <translation>ne peut pas être montré</translation>
    </message>
    <message>
        <source>recorded on %1 at %2</source>
        <translation>enregistré le %1 à %2</translation>
    </message>
    <message>
        <source>The file is still being written; it is shown up to %1</source>
        <translation>Le fichier est en cours d’écriture&#xa0;; il est montré jusqu’à %1</translation>
    </message>
    <message>
        <source>The end of the file is missing or damaged; it is shown up to %1. To repair it: gcm recover</source>
        <translation>La fin du fichier manque ou est abîmée&#xa0;; il est montré jusqu’à %1. Pour le réparer&#xa0;: gcm recover</translation>
    </message>
    <message>
        <source>Parts of the file are damaged and are left out: %1. To repair it: gcm recover</source>
        <translation>Des parties du fichier sont abîmées et manquent&#xa0;: %1. Pour le réparer&#xa0;: gcm recover</translation>
    </message>
    <message>
        <source>Not complete</source>
        <translation>Incomplet</translation>
    </message>
    <message>
        <source>Damaged</source>
        <translation>Abîmé</translation>
    </message>
    <message>
        <source>REPLAY</source>
        <translation>LECTURE</translation>
    </message>
    <message>
        <source>Moment of the recording</source>
        <translation>Instant de l’enregistrement</translation>
    </message>
    <message>
        <source>&amp;Replay</source>
        <translation>&amp;Lecture</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lire ou suspendre</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>Plus &amp;vite</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>Moins vi&amp;te</translation>
    </message>
    <message>
        <source>One row or event for&amp;ward</source>
        <translation>&amp;Avancer d’une ligne ou d’un événement</translation>
    </message>
    <message>
        <source>One row or event &amp;back</source>
        <translation>&amp;Reculer d’une ligne ou d’un événement</translation>
    </message>
    <message>
        <source>&amp;Next event, loss or mark</source>
        <translation>Événement, perte ou repère &amp;suivant</translation>
    </message>
    <message>
        <source>P&amp;revious event, loss or mark</source>
        <translation>Événement, perte ou repère &amp;précédent</translation>
    </message>
    <message>
        <source>To the be&amp;ginning</source>
        <translation>Au &amp;début</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>À la &amp;fin</translation>
    </message>
    <message>
        <source>&amp;Mark this moment, or remove its mark</source>
        <translation>&amp;Marquer cet instant, ou enlever son repère</translation>
    </message>
    <message>
        <source>Open a recording…</source>
        <translation>Ouvrir un enregistrement…</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>REPLAY %1 – gcm-gui</source>
        <translation>LECTURE %1 – gcm-gui</translation>
    </message>
    <message>
        <source>This window shows the recording %1. It is connected to no running system.</source>
        <translation>Cette fenêtre montre l’enregistrement %1. Elle n’est reliée à aucun système en marche.</translation>
    </message>
    <message>
        <source>Add a curve of a recor&amp;ding…</source>
        <translation>Ajouter une courbe &amp;d’un enregistrement…</translation>
    </message>
    <message>
        <source>Ctrl+Left, Ctrl+Right, T</source>
        <translation>Ctrl+Gauche, Ctrl+Droite, T</translation>
    </message>
    <message>
        <source>Shift a recorded curve in time; T sets an exact shift</source>
        <translation>Décaler une courbe enregistrée dans le temps&#xa0;; à une valeur exacte</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Décalage en temps</translation>
    </message>
    <message>
        <source>This time is added to all times of the recording: “-12.5” or “+2 h 03 min”</source>
        <translation>S’ajoute à tous les temps de l’enregistrement&#xa0;: « -12.5 » ou « +2 h 03 min »</translation>
    </message>
    <message>
        <source>Shift, scale, offset and axis…</source>
        <translation>Décalage en temps, échelle, décalage et axe…</translation>
    </message>
    <message>
        <source>Shift…</source>
        <translation>Décaler…</translation>
    </message>
    <message>
        <source>Begin at the left edge</source>
        <translation>Début au bord gauche</translation>
    </message>
    <message>
        <source>Remove its curves</source>
        <translation>Retirer ses courbes</translation>
    </message>
    <message>
        <source>Add a curve of a recording…</source>
        <translation>Ajouter une courbe d’un enregistrement…</translation>
    </message>
    <message>
        <source>%1: &quot;recording&quot; must be a file, and &quot;shift_ns&quot; a whole number of ns up to 100 years</source>
        <translation>%1&#xa0;: &quot;recording&quot; doit être un fichier, et &quot;shift_ns&quot; un nombre entier de ns jusqu’à 100 ans</translation>
    </message>
    <message>
        <source>%1 is shifted by %2; Alt+Left undoes the shift</source>
        <translation>%1 est décalé de %2&#xa0;; Alt+Gauche l’annule</translation>
    </message>
    <message>
        <source>Recorded signals</source>
        <translation>Signaux enregistrés</translation>
    </message>
    <message>
        <source>There is no such number in this recording.</source>
        <translation>Il n’y a pas de tel nombre dans cet enregistrement.</translation>
    </message>
    <message>
        <source>The recording is being opened…</source>
        <translation>L’enregistrement s’ouvre…</translation>
    </message>
    <message>
        <source>Add to the plot</source>
        <translation>Ajouter au tracé</translation>
    </message>
    <message>
        <source>Add curves of %1</source>
        <translation>Ajouter des courbes de %1</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filtre</translation>
    </message>
    <message>
        <source>Filter of the recorded signals</source>
        <translation>Filtre des signaux enregistrés</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Select one or more of %1 signals</source>
        <translation>Choisir un ou plusieurs des %1 signaux</translation>
    </message>
    <message>
        <source>%1 of %2 selected</source>
        <translation>%1 sur %2 choisis</translation>
    </message>
    <message>
        <source>is being read</source>
        <translation>en cours de lecture</translation>
    </message>
    <message>
        <source>the file does not exist any more; the data that was already read is still shown</source>
        <translation>le fichier n’est plus là&#xa0;; ce qui a été lu reste</translation>
    </message>
    <message>
        <source>%1 is damaged, and shown as far as it can be read: %2</source>
        <translation>%1 est endommagé et montré autant qu’il est lisible&#xa0;: %2</translation>
    </message>
    <message>
        <source>Add a curve of a recording</source>
        <translation>Ajouter une courbe d’un enregistrement</translation>
    </message>
    <message>
        <source>%1 is dashed: drag it in time with Ctrl, or press T to set its shift</source>
        <translation>%1 est en tirets&#xa0;: le faire glisser dans le temps avec Ctrl, ou donner son décalage avec T</translation>
    </message>
    <message>
        <source>The shift “%1” is no time, or over 100 years: write seconds, such as -12.5, or +2 h 03 min</source>
        <translation>Le décalage « %1 » n’est pas un temps, ou dépasse 100 ans&#xa0;: écrire des secondes, comme -12.5, ou +2 h 03 min</translation>
    </message>
    <message>
        <source>nothing recorded at this time</source>
        <translation>rien d’enregistré à ce moment</translation>
    </message>
</context>
</TS>
